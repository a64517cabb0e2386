// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_InputDeck_h
#define DirectionFields_InputDeck_h

#include "Types.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/// What a solver knows of an input file of Abaqus, read as its manual says.
struct InputDeck
{
  explicit InputDeck(const std::string& text)
  {
    std::istringstream stream(text);
    std::string line;
    std::string keyword;
    std::map<std::string, std::string> given;
    while (std::getline(stream, line))
    {
      if (line.compare(0, 2, "**") == 0)
      {
        this->Comments.push_back(line);
        continue;
      }
      if (line.compare(0, 1, "*") == 0)
      {
        std::vector<std::string> words = Split(line.substr(1));
        keyword = words[0];
        given.clear();
        for (std::size_t i = 1; i < words.size(); ++i)
        {
          const std::size_t equals = words[i].find('=');
          given[words[i].substr(0, equals)] = words[i].substr(equals + 1);
        }
        continue;
      }
      this->Read(keyword, given, Split(line));
    }
  }

  struct Element
  {
    std::string Type;
    std::vector<int> Nodes;
  };
  struct Section
  {
    std::string Elements;
    std::string Material;
    std::string Orientation;
    double Thickness;
  };
  std::map<int, DirectionFields::Vector3> Nodes;
  std::map<int, Element> Elements;
  std::map<std::string, std::vector<int>> NodeSets;
  std::map<std::string, std::vector<int>> ElementSets;
  std::vector<Section> Sections;
  /// The six numbers of each, by name; of a distribution by its element.
  std::map<std::string, std::vector<double>> Orientations;
  std::map<int, std::vector<double>> Distribution;
  /// The axis that axes of a material are turned around, and the angle.
  std::map<std::string, std::vector<double>> Rotations;
  std::vector<std::string> Comments;
  std::size_t MostWords = 0;
  std::size_t LongestNumber = 0;

private:
  static std::vector<std::string> Split(const std::string& line)
  {
    std::vector<std::string> words;
    std::istringstream stream(line);
    std::string word;
    while (std::getline(stream, word, ','))
    {
      const std::size_t first = word.find_first_not_of(' ');
      words.push_back(first == std::string::npos ? "" : word.substr(first));
    }
    return words;
  }

  static std::vector<double> Doubles(const std::vector<std::string>& words, std::size_t first)
  {
    std::vector<double> numbers;
    for (std::size_t i = first; i < words.size(); ++i)
    {
      numbers.push_back(std::atof(words[i].c_str()));
    }
    return numbers;
  }

  void Read(const std::string& keyword, std::map<std::string, std::string>& given,
    const std::vector<std::string>& words)
  {
    this->MostWords = std::max(this->MostWords, words.size());
    if (keyword == "NODE")
    {
      for (std::size_t k = 1; k < words.size(); ++k)
      {
        this->LongestNumber = std::max(this->LongestNumber, words[k].size());
      }
      const std::vector<double> at = Doubles(words, 1);
      this->Nodes[std::atoi(words[0].c_str())] = { at.at(0), at.at(1), at.at(2) };
    }
    else if (keyword == "ELEMENT")
    {
      Element element{ given["TYPE"], {} };
      for (std::size_t k = 1; k < words.size(); ++k)
      {
        element.Nodes.push_back(std::atoi(words[k].c_str()));
      }
      this->Elements[std::atoi(words[0].c_str())] = element;
    }
    else if (keyword == "ELSET" || keyword == "NSET")
    {
      for (const std::string& word : words)
      {
        (keyword == "ELSET" ? this->ElementSets : this->NodeSets)[given[keyword]].push_back(
          std::atoi(word.c_str()));
      }
    }
    else if (keyword == "SHELL SECTION")
    {
      this->Sections.push_back(
        { given["ELSET"], given["MATERIAL"], given["ORIENTATION"], std::atof(words[0].c_str()) });
    }
    else if (keyword == "ORIENTATION" && words.size() == 6)
    {
      this->Orientations[given["NAME"]] = Doubles(words, 0);
    }
    else if (keyword == "ORIENTATION" && words.size() == 2)
    {
      this->Rotations[given["NAME"]] = Doubles(words, 0);
    }
    else if (keyword == "DISTRIBUTION" && !words[0].empty())
    {
      this->Distribution[std::atoi(words[0].c_str())] = Doubles(words, 1);
    }
  }
};

#endif
