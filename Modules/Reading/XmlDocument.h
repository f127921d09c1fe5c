/**
 * @file    XmlDocument.h
 * @brief   the elements of a VTK XML file and where in the file their content is
 */

#ifndef XmlDocument_h
#define XmlDocument_h

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

struct XmlElement
{
  std::string name;
  std::map<std::string, std::string> attributes;
  /// The index of the element around this one in the document; its own at the outermost.
  std::size_t parent = 0;
  /// From the first byte after the start tag to the next tag.
  std::uint64_t contentBegin = 0;
  std::uint64_t contentEnd = 0;

  std::optional<std::string> Attribute(const std::string& attribute) const;

  /**
   * The value; throws VolumeReadingError where there is none.
   */
  std::string Needed(const std::string& attribute) const;
};

/**
 * All elements in the order of their start tags; AppendedData, which holds what is not XML, is the
 * last to be looked at. Throws VolumeReadingError where the file ends early or is not XML.
 */
std::vector<XmlElement> ReadXmlElements(const std::filesystem::path& path);

}

#endif
