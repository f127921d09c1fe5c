#include "JsonObject.h"

#include "InputError.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace penumbra
{
namespace
{
constexpr std::size_t LongestValueInMessages = 60;

std::string InWords(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string Join(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

// Whole numbers may be written as 256 or 256.0. Beyond 2^53 a double no longer tells them apart.
bool IsIntegerWithin(const nlohmann::json& value, std::int64_t minimum, std::int64_t maximum)
{
  constexpr double largestExact = 9007199254740992.0;
  if (!value.is_number())
  {
    return false;
  }
  const double number = value.get<double>();
  return std::abs(number) <= largestExact && number == std::floor(number) &&
    number >= static_cast<double>(minimum) && number <= static_cast<double>(maximum);
}

std::string IntegersInWords(std::int64_t minimum, std::int64_t maximum)
{
  return "from " + std::to_string(minimum) + " to " + std::to_string(maximum);
}
}

//------------------------------------------------------------------------------
bool NumberRange::Contains(double number) const
{
  return std::isfinite(number) &&
    (this->MinimumIncluded ? number >= this->Minimum : number > this->Minimum) &&
    (this->MaximumIncluded ? number <= this->Maximum : number < this->Maximum);
}

//------------------------------------------------------------------------------
std::string NumberRange::Describe() const
{
  const bool hasMinimum = this->Minimum > std::numeric_limits<double>::lowest();
  const bool hasMaximum = this->Maximum < std::numeric_limits<double>::max();
  if (hasMinimum && hasMaximum && this->MinimumIncluded && this->MaximumIncluded)
  {
    return "from " + InWords(this->Minimum) + " to " + InWords(this->Maximum);
  }
  std::string text;
  if (hasMinimum)
  {
    text = (this->MinimumIncluded ? "at least " : "more than ") + InWords(this->Minimum);
  }
  if (hasMaximum)
  {
    text += text.empty() ? "" : " and ";
    text += (this->MaximumIncluded ? "at most " : "less than ") + InWords(this->Maximum);
  }
  return text;
}

//------------------------------------------------------------------------------
bool IsUtf8(const std::string& text)
{
  try
  {
    nlohmann::json(text).dump();
    return true;
  }
  catch (const nlohmann::json::type_error&)
  {
    return false;
  }
}

//------------------------------------------------------------------------------
std::string ValueInWords(const nlohmann::json& value)
{
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > LongestValueInMessages)
  {
    text = text.substr(0, LongestValueInMessages) + "...";
  }
  return text;
}

//------------------------------------------------------------------------------
void RefuseValue(const std::string& path, const nlohmann::json& value, const std::string& accepted)
{
  throw InputError(path + " is " + ValueInWords(value) + "; accepted: " + accepted);
}

//------------------------------------------------------------------------------
JsonObject::JsonObject(const nlohmann::json& value, std::string path)
  : Value(value)
  , Path(std::move(path))
{
  if (!value.is_object())
  {
    RefuseValue(this->Path.empty() ? "the scene" : this->Path, value, "an object, { ... }");
  }
}

//------------------------------------------------------------------------------
std::string JsonObject::PathOf(const std::string& key) const
{
  return this->Path.empty() ? key : this->Path + "." + key;
}

//------------------------------------------------------------------------------
const nlohmann::json* JsonObject::Find(const std::string& key)
{
  if (std::find(this->KnownKeys.begin(), this->KnownKeys.end(), key) == this->KnownKeys.end())
  {
    this->KnownKeys.push_back(key);
  }
  const auto found = this->Value.find(key);
  return found == this->Value.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
void JsonObject::Read(const std::string& key, bool& target)
{
  if (const nlohmann::json* value = this->Find(key))
  {
    if (!value->is_boolean())
    {
      RefuseValue(this->PathOf(key), *value, "true, false");
    }
    target = value->get<bool>();
  }
}

//------------------------------------------------------------------------------
void JsonObject::Read(const std::string& key, std::string& target)
{
  if (const nlohmann::json* value = this->Find(key))
  {
    if (!value->is_string())
    {
      RefuseValue(this->PathOf(key), *value, "a string");
    }
    target = value->get<std::string>();
  }
}

//------------------------------------------------------------------------------
void JsonObject::Read(const std::string& key, double& target, const NumberRange& range)
{
  if (const nlohmann::json* value = this->Find(key))
  {
    if (!value->is_number() || !range.Contains(value->get<double>()))
    {
      const std::string limits = range.Describe();
      RefuseValue(this->PathOf(key), *value, "a number" + (limits.empty() ? "" : " " + limits));
    }
    target = value->get<double>();
  }
}

//------------------------------------------------------------------------------
void JsonObject::Read(
  const std::string& key, std::int64_t& target, std::int64_t minimum, std::int64_t maximum)
{
  if (const nlohmann::json* value = this->Find(key))
  {
    if (!IsIntegerWithin(*value, minimum, maximum))
    {
      RefuseValue(this->PathOf(key), *value, "a whole number " + IntegersInWords(minimum, maximum));
    }
    target = static_cast<std::int64_t>(value->get<double>());
  }
}

//------------------------------------------------------------------------------
void JsonObject::ReadNumbers(
  const std::string& key, double* target, std::size_t size, const NumberRange& range)
{
  const nlohmann::json* value = this->Find(key);
  if (!value)
  {
    return;
  }
  const auto accepted = [&range](const nlohmann::json& entry)
  { return entry.is_number() && range.Contains(entry.get<double>()); };
  if (!value->is_array() || value->size() != size ||
    !std::all_of(value->begin(), value->end(), accepted))
  {
    const std::string limits = range.Describe();
    RefuseValue(this->PathOf(key), *value,
      "an array of " + std::to_string(size) + " numbers" + (limits.empty() ? "" : ", each ") +
        limits);
  }
  std::transform(value->begin(), value->end(), target,
    [](const nlohmann::json& entry) { return entry.get<double>(); });
}

//------------------------------------------------------------------------------
void JsonObject::ReadIntegers(
  const std::string& key, int* target, std::size_t size, int minimum, int maximum)
{
  const nlohmann::json* value = this->Find(key);
  if (!value)
  {
    return;
  }
  const auto accepted = [minimum, maximum](const nlohmann::json& entry)
  { return IsIntegerWithin(entry, minimum, maximum); };
  if (!value->is_array() || value->size() != size ||
    !std::all_of(value->begin(), value->end(), accepted))
  {
    RefuseValue(this->PathOf(key), *value,
      "an array of " + std::to_string(size) + " whole numbers, each " +
        IntegersInWords(minimum, maximum));
  }
  std::transform(value->begin(), value->end(), target,
    [](const nlohmann::json& entry) { return static_cast<int>(entry.get<double>()); });
}

//------------------------------------------------------------------------------
std::size_t JsonObject::FindChoice(const std::string& key, const std::vector<std::string>& names)
{
  std::string wanted;
  const nlohmann::json& value = *this->Find(key);
  if (value.is_string())
  {
    wanted = value.get<std::string>();
  }
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end())
  {
    return static_cast<std::size_t>(found - names.begin());
  }
  RefuseValue(this->PathOf(key), value, Join(names));
}

//------------------------------------------------------------------------------
std::vector<std::pair<const nlohmann::json*, std::string>> JsonObject::ReadArray(
  const std::string& key)
{
  std::vector<std::pair<const nlohmann::json*, std::string>> entries;
  if (const nlohmann::json* value = this->Find(key))
  {
    if (!value->is_array())
    {
      RefuseValue(this->PathOf(key), *value, "an array, [ ... ]");
    }
    for (const nlohmann::json& entry : *value)
    {
      entries.emplace_back(&entry, this->PathOf(key) + "." + std::to_string(entries.size()));
    }
  }
  return entries;
}

//------------------------------------------------------------------------------
void JsonObject::RefuseUnknownKeys() const
{
  for (const auto& [key, value] : this->Value.items())
  {
    if (std::find(this->KnownKeys.begin(), this->KnownKeys.end(), key) == this->KnownKeys.end())
    {
      throw InputError(this->PathOf(key) + " is " + ValueInWords(value) +
        ": unknown key; accepted: " + Join(this->KnownKeys));
    }
  }
}

}
