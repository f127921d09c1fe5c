/**
 * @class   JsonObject
 * @brief   one object of a scene file, read key by key
 *
 * Each Read function leaves its target alone where the key is absent, and throws an InputError that
 * names the key with its path, its value and what is accepted, where the value is of another type
 * or out of range. RefuseUnknownKeys then finds the keys that nothing asked for.
 */

#ifndef JsonObject_h
#define JsonObject_h

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra
{

/// Which finite numbers a key accepts.
struct NumberRange
{
  double Minimum = std::numeric_limits<double>::lowest();
  double Maximum = std::numeric_limits<double>::max();
  bool MinimumIncluded = true;
  bool MaximumIncluded = true;

  bool Contains(double number) const;
  /// Such as "a number from 0 to 1".
  std::string Describe() const;
};

constexpr NumberRange AnyNumber;
constexpr NumberRange ZeroOrMore{ 0.0 };
constexpr NumberRange MoreThanZero{ 0.0, std::numeric_limits<double>::max(), false };
constexpr NumberRange ZeroToOne{ 0.0, 1.0 };
/// VTK keeps the length of a step in single precision.
constexpr NumberRange StepLengths{ 1e-30, 1e30 };

/// Whether a text is valid UTF-8, which all texts in JSON are.
bool IsUtf8(const std::string& text);

/// A JSON value on one line, shortened for a message.
std::string ValueInWords(const nlohmann::json& value);

/// An InputError about the value of a key.
[[noreturn]] void RefuseValue(
  const std::string& path, const nlohmann::json& value, const std::string& accepted);

class JsonObject
{
public:
  /// `path` is the key path of the object, empty for the whole scene.
  JsonObject(const nlohmann::json& value, std::string path);

  /// "lights.0.shadow" for the key "shadow" of the object lights.0.
  std::string PathOf(const std::string& key) const;

  /// The value, or null where the key is absent. The key counts as known from now on.
  const nlohmann::json* Find(const std::string& key);

  void Read(const std::string& key, bool& target);
  void Read(const std::string& key, std::string& target);
  void Read(const std::string& key, double& target, const NumberRange& range);
  void Read(
    const std::string& key, std::int64_t& target, std::int64_t minimum, std::int64_t maximum);

  template <std::size_t Size>
  void Read(const std::string& key, std::array<double, Size>& target, const NumberRange& range)
  {
    this->ReadNumbers(key, target.data(), Size, range);
  }

  template <std::size_t Size>
  void Read(const std::string& key, std::array<int, Size>& target, int minimum, int maximum)
  {
    this->ReadIntegers(key, target.data(), Size, minimum, maximum);
  }

  template <typename Value, typename... Limits>
  void Read(const std::string& key, std::optional<Value>& target, const Limits&... limits)
  {
    if (this->Find(key))
    {
      target.emplace();
      this->Read(key, *target, limits...);
    }
  }

  /// One of several names, each standing for a value.
  template <typename Value>
  void ReadChoice(const std::string& key, Value& target,
    const std::vector<std::pair<std::string, Value>>& choices)
  {
    std::vector<std::string> names;
    for (const auto& choice : choices)
    {
      names.push_back(choice.first);
    }
    if (this->Find(key))
    {
      target = choices[this->FindChoice(key, names)].second;
    }
  }

  /// The entries of an array, each with its path. Empty where the key is absent.
  std::vector<std::pair<const nlohmann::json*, std::string>> ReadArray(const std::string& key);

  void RefuseUnknownKeys() const;

private:
  void ReadNumbers(
    const std::string& key, double* target, std::size_t size, const NumberRange& range);
  void ReadIntegers(
    const std::string& key, int* target, std::size_t size, int minimum, int maximum);
  std::size_t FindChoice(const std::string& key, const std::vector<std::string>& names);

  const nlohmann::json& Value;
  std::string Path;
  std::vector<std::string> KnownKeys;
};

}

#endif
