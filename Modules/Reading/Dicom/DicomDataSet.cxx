#include "DicomDataSet.h"

#include "OneLine.h"

#include <gdcmByteValue.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>

namespace penumbra
{

namespace
{

std::string Trimmed(const std::string& text)
{
  const std::string blanks(" \t\r\n\0", 5);
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Texts may be in any character set, or damaged: what is no UTF-8 becomes its replacement
// character.
std::string ToUtf8(const std::string& text)
{
  using nlohmann::json;
  const std::string quoted = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  return OneLine(json::parse(quoted).get<std::string>());
}

std::optional<double> ToNumber(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  if (!(stream >> number) || !(stream >> std::ws).eof() || !std::isfinite(number))
  {
    return std::nullopt;
  }
  return number;
}

template <typename Value>
std::optional<Value> FromBytes(const std::string& bytes)
{
  if (bytes.size() < sizeof(Value))
  {
    return std::nullopt;
  }
  Value value;
  std::memcpy(&value, bytes.data(), sizeof(Value));
  return value;
}

}

bool DicomDataSet::Has(const gdcm::Tag& tag) const
{
  return this->Data->FindDataElement(tag);
}

std::string DicomDataSet::Bytes(const gdcm::Tag& tag) const
{
  if (!this->Has(tag))
  {
    return {};
  }
  const gdcm::ByteValue* value = this->Data->GetDataElement(tag).GetByteValue();
  return value && value->GetPointer() ? std::string(value->GetPointer(), value->GetLength())
                                      : std::string();
}

std::string DicomDataSet::Text(const gdcm::Tag& tag) const
{
  return ToUtf8(Trimmed(this->Bytes(tag)));
}

std::vector<double> DicomDataSet::Decimals(const gdcm::Tag& tag) const
{
  std::vector<double> numbers;
  std::istringstream list(this->Bytes(tag)); // the text may be shortened
  for (std::string entry; std::getline(list, entry, '\\');)
  {
    const auto number = ToNumber(Trimmed(entry));
    if (!number)
    {
      return {};
    }
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<double> DicomDataSet::Decimal(const gdcm::Tag& tag) const
{
  const std::vector<double> numbers = this->Decimals(tag);
  return numbers.empty() ? std::nullopt : std::optional<double>(numbers.front());
}

std::optional<std::uint32_t> DicomDataSet::Integer(const gdcm::Tag& tag) const
{
  const std::string bytes = this->Bytes(tag);
  if (bytes.size() < sizeof(std::uint32_t))
  {
    return FromBytes<std::uint16_t>(bytes);
  }
  const gdcm::VR type = this->Data->GetDataElement(tag).GetVR();
  const bool isLong = type == gdcm::VR::UL || type == gdcm::VR::SL;
  if (isLong)
  {
    return FromBytes<std::uint32_t>(bytes);
  }
  return FromBytes<std::uint16_t>(bytes);
}

std::vector<std::uint32_t> DicomDataSet::Integers(const gdcm::Tag& tag) const
{
  std::vector<std::uint32_t> values;
  const std::string bytes = this->Bytes(tag);
  for (std::size_t at = 0; at + 2 <= bytes.size(); at += 2)
  {
    values.push_back(*FromBytes<std::uint16_t>(bytes.substr(at, 2)));
  }
  return values;
}

std::optional<double> DicomDataSet::Real(const gdcm::Tag& tag) const
{
  const std::string bytes = this->Bytes(tag);
  std::optional<double> number = FromBytes<double>(bytes);
  if (!number)
  {
    number = FromBytes<float>(bytes);
  }
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::vector<gdcm::Tag> DicomDataSet::Tags(const gdcm::Tag& tag) const
{
  std::vector<gdcm::Tag> tags;
  const std::vector<std::uint32_t> halves = this->Integers(tag);
  for (std::size_t at = 0; at + 2 <= halves.size(); at += 2)
  {
    tags.emplace_back(
      static_cast<std::uint16_t>(halves[at]), static_cast<std::uint16_t>(halves[at + 1]));
  }
  return tags;
}

DicomDataSet::Sequence DicomDataSet::Items(const gdcm::Tag& tag) const
{
  Sequence sequence;
  if (this->Has(tag))
  {
    sequence.Items = this->Data->GetDataElement(tag).GetValueAsSQ();
  }
  return sequence;
}

std::size_t DicomDataSet::Sequence::Size() const
{
  return this->Items ? this->Items->GetNumberOfItems() : 0;
}

DicomDataSet DicomDataSet::Sequence::Item(std::size_t index) const
{
  return DicomDataSet(this->Items->GetItem(index + 1).GetNestedDataSet());
}

}
