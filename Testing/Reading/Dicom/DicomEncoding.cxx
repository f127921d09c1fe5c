#include "DicomEncoding.h"

#include "gdcmDicts.h"
#include "gdcmGlobal.h"
#include "gdcmSequenceOfItems.h"

#include <cstdint>
#include <map>
#include <sstream>
#include <stdexcept>

namespace
{

template <typename Value>
std::string Binary(Value value)
{
  return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string BinaryTag(const std::string& text)
{
  gdcm::Tag tag;
  tag.ReadFromCommaSeparatedString(text.c_str());
  return Binary(tag.GetGroup()) + Binary(tag.GetElement());
}

std::string BinaryValue(const std::string& text, gdcm::VR::VRType type)
{
  switch (type)
  {
    case gdcm::VR::US:
      return Binary(static_cast<std::uint16_t>(std::stol(text)));
    case gdcm::VR::SS:
      return Binary(static_cast<std::int16_t>(std::stol(text)));
    case gdcm::VR::UL:
      return Binary(static_cast<std::uint32_t>(std::stoll(text)));
    case gdcm::VR::SL:
      return Binary(static_cast<std::int32_t>(std::stoll(text)));
    case gdcm::VR::FL:
      return Binary(std::stof(text));
    case gdcm::VR::FD:
      return Binary(std::stod(text));
    case gdcm::VR::AT:
      return BinaryTag(text);
    default:
      throw std::invalid_argument("no text makes such an element");
  }
}

}

DicomElementKind FindElement(const std::string& keyword)
{
  static std::map<std::string, DicomElementKind> known;
  const auto found = known.find(keyword);
  if (found != known.end())
  {
    return found->second;
  }
  gdcm::Tag tag;
  const auto& entry = gdcm::Global::GetInstance().GetDicts().GetPublicDict().GetDictEntryByKeyword(
    keyword.c_str(), tag);
  if (tag == gdcm::Tag(0xffff, 0xffff))
  {
    throw std::invalid_argument("DICOM has no element " + keyword);
  }
  return known[keyword] = { tag, entry.GetVR() };
}

std::vector<std::string> Parts(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, '\\');)
  {
    parts.push_back(part);
  }
  return parts;
}

std::string Value(const std::string& text, gdcm::VR::VRType type)
{
  if (gdcm::VR::IsASCII(type))
  {
    return text.size() % 2 == 0 ? text : text + (type == gdcm::VR::UI ? '\0' : ' ');
  }
  std::string bytes;
  for (const auto& part : Parts(text))
  {
    bytes += BinaryValue(part, type);
  }
  return bytes;
}

gdcm::DataElement Element(const gdcm::Tag& tag, gdcm::VR::VRType type, const std::string& bytes)
{
  gdcm::DataElement element(tag);
  element.SetVR(type);
  element.SetByteValue(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  return element;
}

gdcm::DataElement Sequence(const std::string& keyword, const std::vector<gdcm::DataSet>& items)
{
  auto sequence = gdcm::SequenceOfItems::New();
  sequence->SetLengthToUndefined();
  for (const auto& dataSet : items)
  {
    gdcm::Item item;
    item.SetVLToUndefined();
    item.SetNestedDataSet(dataSet);
    sequence->AddItem(item);
  }
  gdcm::DataElement element(FindElement(keyword).tag);
  element.SetVR(gdcm::VR::SQ);
  element.SetValue(*sequence);
  element.SetVLToUndefined();
  return element;
}
