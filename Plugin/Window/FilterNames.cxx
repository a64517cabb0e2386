// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterNames.h"

#include "pqApplicationCore.h"
#include "pqObjectBuilder.h"
#include "pqPipelineFilter.h"
#include "pqServerManagerModel.h"
#include "vtkSMProxy.h"

#include <QMap>
#include <QString>

namespace
{
/// What the filters of the plugin make, by their names in the XML.
const QMap<QString, QString>& Products()
{
  static const QMap<QString, QString> products = {
    { "DirectionField", "Field" },
    { "DirectionFieldGlyphs", "Glyphs" },
    { "DirectionFieldStreamlines", "Streamlines" },
    { "StripePattern", "Stripes" },
    { "EditSingularities", "Edited field" },
    { "GuidanceFromCurves", "Guidance" },
    { "CompareDirectionFields", "Comparison" },
    { "ReadDirectionField", "Field from a file" },
    { "FieldAlignedRemesh", "Remesh" },
  };
  return products;
}

/// The name of what a filter is made of, in short: that of its mesh, where it has been given by
/// this class.
QString ShortNameOf(pqPipelineSource* source)
{
  const QString name = source->getSMName();
  for (const QString& product : Products())
  {
    const QString prefix = product + " of ";
    if (name.startsWith(prefix))
    {
      return name.mid(prefix.size());
    }
  }
  return name;
}

QString Unique(const QString& name)
{
  auto* const model = pqApplicationCore::instance()->getServerManagerModel();
  QString unique = name;
  for (int number = 2; model->findItem<pqPipelineSource*>(unique); ++number)
  {
    unique = QString("%1 (%2)").arg(name).arg(number);
  }
  return unique;
}
}

//------------------------------------------------------------------------------
FilterNames::FilterNames(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void FilterNames::startup()
{
  auto* const core = pqApplicationCore::instance();
  if (core && core->getObjectBuilder())
  {
    this->connect(core->getObjectBuilder(), &pqObjectBuilder::filterCreated, this,
      &FilterNames::name, Qt::UniqueConnection);
  }
}

//------------------------------------------------------------------------------
void FilterNames::name(pqPipelineSource* source)
{
  auto* const filter = qobject_cast<pqPipelineFilter*>(source);
  const QString product = filter ? Products().value(filter->getProxy()->GetXMLName()) : QString();
  pqPipelineSource* const input = product.isEmpty() ? nullptr : filter->getInput(0);
  if (input)
  {
    filter->rename(Unique(product + " of " + ShortNameOf(input)));
  }
}
