#include "TextVoxels.h"

#include "ByteStream.h"
#include "HeaderText.h"
#include "ScalarTypes.h"
#include "VolumeReadingError.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

namespace penumbra
{

namespace
{

class NumberStream
{
public:
  explicit NumberStream(ByteStream& bytes)
    : Bytes(bytes)
  {
  }

  /// The next word; empty at the end.
  std::string Next()
  {
    // No number is written longer than this; it keeps binary data from being taken for one word.
    constexpr std::size_t longestWord = 100;
    std::string word;
    char letter = 0;
    while (this->NextLetter(letter))
    {
      const bool blank = letter == ' ' || (letter >= '\t' && letter <= '\r');
      if (blank && !word.empty())
      {
        break;
      }
      if (!blank)
      {
        word += letter;
      }
      if (word.size() > longestWord)
      {
        throw VolumeReadingError("its voxels are \"" + word + "...\"; numbers in text are needed");
      }
    }
    return word;
  }

private:
  bool NextLetter(char& letter)
  {
    if (this->Position == this->Size)
    {
      this->Size =
        static_cast<std::size_t>(this->Bytes.Read(this->Buffer.data(), this->Buffer.size()));
      this->Position = 0;
    }
    if (this->Position < this->Size)
    {
      letter = this->Buffer[this->Position++];
      return true;
    }
    return false;
  }

  ByteStream& Bytes;
  std::array<char, 1 << 14> Buffer;
  std::size_t Size = 0;
  std::size_t Position = 0;
};

template <typename Value>
Value ToVoxel(const std::string& word, int scalarType)
{
  const double number = ToNumber(word, "a voxel");
  if constexpr (std::is_integral_v<Value>)
  {
    const double lowest = static_cast<double>(std::numeric_limits<Value>::lowest());
    const double beyond = static_cast<double>(std::numeric_limits<Value>::max()) + 1.0;
    if (!(number >= lowest && number < beyond) || number != std::floor(number))
    {
      throw VolumeReadingError("a voxel is \"" + word + "\"; a number of type " +
        ScalarTypeName(scalarType) + " is needed");
    }
  }
  return static_cast<Value>(number);
}

template <typename Value>
void ReadVoxels(NumberStream& words, int scalarType, std::uint64_t count, Value* destination)
{
  for (std::uint64_t voxel = 0; voxel < count; ++voxel)
  {
    const std::string word = words.Next();
    if (word.empty())
    {
      throw VolumeReadingError("its voxels end after " + std::to_string(voxel) + " of " +
        std::to_string(count) + " numbers");
    }
    destination[voxel] = ToVoxel<Value>(word, scalarType);
  }
}

}

void ReadTextVoxels(ByteStream& stream, int scalarType, std::uint64_t count, void* destination)
{
  NumberStream words(stream);
  switch (scalarType)
  {
    vtkTemplateMacro(ReadVoxels(words, scalarType, count, static_cast<VTK_TT*>(destination)));
  }
  if (!words.Next().empty())
  {
    throw VolumeReadingError(
      "its data holds more than the " + std::to_string(count) + " numbers that its header states");
  }
}

}
