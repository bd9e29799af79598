// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEMO_JET_FITTING_3_TOOL_VTP_FILE_H
#define CGAL_DEMO_JET_FITTING_3_TOOL_VTP_FILE_H

#include "Bytes.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// A VTK XML file of type PolyData, whose arrays follow the XML as raw bytes. Arrays are declared first, with the
// functions that write them, and written in the same order.
class Vtp_file
{
public:
  using Write = std::function<void(Bytes&)>;

  // The description becomes field data: an array of strings.
  Vtp_file(const std::string& counts, const std::vector<std::string>& description)
  {
    m_xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" header_type=\"UInt64\" byte_order=\"" +
            std::string(is_little_endian() ? "LittleEndian" : "BigEndian") + "\">\n<PolyData>\n<FieldData>\n";
    m_xml += "<Array type=\"String\" Name=\"description\" NumberOfTuples=\"" + std::to_string(description.size()) +
             "\" format=\"ascii\">\n";
    for (const std::string& line : description) { // codes of characters, 0 after each string
      for (const char c : line) m_xml += std::to_string(static_cast<unsigned char>(c)) + ' ';
      m_xml += "0\n";
    }
    m_xml += "</Array>\n</FieldData>\n<Piece " + counts + ">\n";
  }

  void open(const std::string& section, const std::string& attributes = "")
  {
    m_xml += '<' + section + (attributes.empty() ? "" : ' ' + attributes) + ">\n";
  }
  void close(const std::string& section) { m_xml += "</" + section + ">\n"; }

  // A name of a type: Float64, Float32, Int32, UInt8, UInt16. write(bytes) adds `tuples` times `components` numbers.
  void add_array(const std::string& type, const std::string& name, int components, std::size_t tuples, Write write)
  {
    const std::size_t size = tuples * static_cast<std::size_t>(components) * size_of(type);
    m_xml += "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
             std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(m_offset) + "\"/>\n";
    m_offset += sizeof(std::uint64_t) + size;
    m_arrays.emplace_back(size, std::move(write));
  }

  void write(std::ostream& out) const
  {
    out << m_xml << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    for (const auto& [size, write_array] : m_arrays) {
      Bytes bytes(out);
      bytes.add(static_cast<std::uint64_t>(size));
      write_array(bytes);
    }
    out << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  // The type's name ends with its number of bits.
  static std::size_t size_of(const std::string& type)
  {
    return std::stoul(type.substr(type.find_first_of("0123456789"))) / 8;
  }

  std::string m_xml;
  std::size_t m_offset = 0;
  std::vector<std::pair<std::size_t, Write>> m_arrays;
};

} // namespace tool

#endif // CGAL_DEMO_JET_FITTING_3_TOOL_VTP_FILE_H
