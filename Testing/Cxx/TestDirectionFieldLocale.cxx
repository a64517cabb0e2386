// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files and sentences of users whose numbers have a decimal comma: TestDirectionFieldLocale DIRECTORY
//
// The streams of C++ have such a locale in any case; the functions of C have it where the machine has
// de_DE.UTF-8 (environment LOCPATH).

#include "FieldFiles.h"
#include "Fields.h"
#include "PipelineChecks.h"

#include "vtkAbaqusMeshWriter.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkStripePattern.h"

#include <clocale>
#include <locale>
#include <sstream>

using namespace Checks;
using namespace FieldFiles;

namespace
{
/// Numbers as Germans write them: 1.234,5
class Comma : public std::numpunct<char>
{
protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// All that a user sees of some filters: the files' texts, and the sentences.
std::vector<std::string> Seen(const std::string& name)
{
  std::vector<std::string> seen;
  const auto add = [&seen](vtkDirectionFieldAlgorithm* filter, vtkPolyData* input)
  {
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputDataObject(0, input);
    filter->Update();
    for (const std::vector<std::string>& list : { messages->Errors, messages->Warnings })
    {
      for (const std::string& message : list)
      {
        // VTK begins with a place in memory.
        seen.push_back(message.substr(message.find("): ") + 1));
      }
    }
    vtkFieldData* const data = filter->GetOutputDataObject(0)->GetFieldData();
    auto* const summary = vtkStringArray::SafeDownCast(data->GetAbstractArray("Summary"));
    seen.push_back(summary ? summary->GetValue(0) : "(none)");
  };
  auto mesh = PolyMeshes::Pebble(4);
  vtkNew<vtkDirectionField> hurried;
  hurried->SetSolver(vtkDirectionField::SOLVER_MULTIGRID);
  hurried->SetMaximumIterations(1);
  hurried->SetTolerance(1e-12);
  add(hurried, mesh);
  auto field = Field(mesh, 2);
  vtkNew<vtkStripePattern> stripes;
  stripes->SetLineOffset(0.3);
  add(stripes, field);
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetNumberOfFaces(1500);
  add(remesh, mesh);
  vtkNew<vtkDirectionFieldGlyphs> glyphs;
  add(glyphs, field);

  vtkNew<vtkAbaqusMeshWriter> writer;
  writer->SetFileName((name + ".inp").c_str());
  writer->SetInputData(remesh->GetOutput());
  writer->SetThickness(1234.5);
  CHECK(writer->Write() == 1);
  seen.push_back(ReadFile(name + ".inp"));
  CHECK(seen.back().find("\n1234.5\n") != std::string::npos);

  Remove(name);
  CHECK(Write(field, name + ".rawfield", true));
  for (const char* ending : { ".rawfield", ".sing", ".obj" })
  {
    seen.push_back(ReadFile(name + ending));
  }
  auto back = Read(mesh, name + ".rawfield");
  double worst = back && Direction(back, 0) ? 0.0 : 1.0;
  for (vtkIdType i = 0; worst < 1.0 && i < mesh->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double difference =
        Direction(back, 0)->GetComponent(i, c) - Direction(field, 0)->GetComponent(i, c);
      worst = std::max(worst, std::abs(difference));
    }
  }
  CHECK(worst < 1e-12);
  return seen;
}
}

int TestDirectionFieldLocale(int argc, char* argv[])
{
  const std::string name = std::string(argc > 1 ? argv[1] : ".") + "/locale";
  const std::vector<std::string> english = Seen(name);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  std::ostringstream number;
  number << 1234.5;
  CHECK(number.str() == "1.234,5");
  const char* const german = std::setlocale(LC_ALL, "de_DE.UTF-8");
  std::cout << (german ? "C has a decimal comma, too"
                       : "skipped for C, for this machine has no de_DE.UTF-8")
            << std::endl;
  CHECK(!german || std::string(std::localeconv()->decimal_point) == ",");
  const std::vector<std::string> seen = Seen(name);
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  CHECK(seen.size() == english.size());
  bool hasFigures = false;
  for (std::size_t k = 0; k < std::min(seen.size(), english.size()); ++k)
  {
    hasFigures = hasFigures || english[k].find("0.") != std::string::npos;
    if (seen[k] != english[k])
    {
      std::cerr << seen[k].substr(0, 300) << "\nis in English\n"
                << english[k].substr(0, 300) << std::endl;
    }
    CHECK(seen[k] == english[k]);
  }
  CHECK(hasFigures);
  return Result();
}
