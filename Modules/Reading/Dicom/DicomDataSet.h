/**
 * @class   DicomDataSet
 * @brief   values of a GDCM data set by their tags, whatever a damaged file holds there
 *
 * A value that is absent or makes no sense is an empty optional, text or list.
 */

#ifndef DicomDataSet_h
#define DicomDataSet_h

#include <gdcmDataSet.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmSmartPointer.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

class DicomDataSet
{
public:
  explicit DicomDataSet(const gdcm::DataSet& data)
    : Data(&data)
  {
  }

  bool Has(const gdcm::Tag& tag) const;

  /// In UTF-8, one line of a length that can be read, without the blanks and NULs around it.
  std::string Text(const gdcm::Tag& tag) const;

  /// Of a decimal or integer string (DS, IS): its finite numbers, or none where one is not.
  std::vector<double> Decimals(const gdcm::Tag& tag) const;
  std::optional<double> Decimal(const gdcm::Tag& tag) const;

  /// The first `Count` numbers of a decimal string.
  template <std::size_t Count>
  std::optional<std::array<double, Count>> DecimalArray(const gdcm::Tag& tag) const
  {
    const std::vector<double> numbers = this->Decimals(tag);
    if (numbers.size() < Count)
    {
      return std::nullopt;
    }
    std::array<double, Count> values;
    std::copy_n(numbers.begin(), Count, values.begin());
    return values;
  }

  /// Of binary types (US, SS, UL, SL): the bits of the first value, without sign.
  std::optional<std::uint32_t> Integer(const gdcm::Tag& tag) const;

  /// All values of unsigned short integers (US).
  std::vector<std::uint32_t> Integers(const gdcm::Tag& tag) const;

  /// Of a binary floating point type (FL, FD).
  std::optional<double> Real(const gdcm::Tag& tag) const;

  /// Attribute tags (AT).
  std::vector<gdcm::Tag> Tags(const gdcm::Tag& tag) const;

  /// The items of a sequence.
  class Sequence
  {
  public:
    std::size_t Size() const;
    DicomDataSet Item(std::size_t index) const;

  private:
    friend class DicomDataSet;
    gdcm::SmartPointer<gdcm::SequenceOfItems> Items;
  };
  Sequence Items(const gdcm::Tag& tag) const;

private:
  std::string Bytes(const gdcm::Tag& tag) const;

  const gdcm::DataSet* Data;
};

}

#endif
