#include "Base64.h"

#include "ByteStream.h"
#include "VolumeReadingError.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace penumbra
{

namespace
{

class Base64Bytes : public ByteStream
{
public:
  explicit Base64Bytes(std::unique_ptr<ByteStream> text)
    : Text(std::move(text))
    , Buffer(1 << 14)
  {
  }

  std::uint64_t Read(void* destination, std::uint64_t size) override
  {
    unsigned char* const bytes = static_cast<unsigned char*>(destination);
    std::uint64_t read = 0;
    while (read < size && (this->DecodedUsed < this->DecodedSize || this->DecodeGroup()))
    {
      bytes[read++] = this->Decoded[this->DecodedUsed++];
    }
    return read;
  }

private:
  // Four letters are three bytes; = in the last places says that there are fewer.
  bool DecodeGroup()
  {
    std::uint32_t bits = 0;
    std::size_t letters = 0;
    std::size_t padding = 0;
    unsigned char letter = 0;
    while (letters < 4 && this->NextLetter(letter))
    {
      padding += letter == '=' ? 1 : 0;
      bits = bits << 6 | Value(letter);
      ++letters;
    }
    if (letters < 4)
    {
      return false;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Decoded[i] = static_cast<unsigned char>(bits >> (16 - 8 * i));
    }
    this->DecodedSize = 3 - std::min<std::size_t>(padding, 2);
    this->DecodedUsed = 0;
    return true;
  }

  bool NextLetter(unsigned char& letter)
  {
    do
    {
      if (this->Used == this->Filled)
      {
        this->Filled =
          static_cast<std::size_t>(this->Text->Read(this->Buffer.data(), this->Buffer.size()));
        this->Used = 0;
      }
      if (this->Used == this->Filled || this->Buffer[this->Used] == '<')
      {
        return false;
      }
      letter = this->Buffer[this->Used++];
    } while (letter == ' ' || (letter >= '\t' && letter <= '\r'));
    return true;
  }

  static std::uint32_t Value(unsigned char letter)
  {
    static const std::string letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t place = letter == '=' ? 0 : letters.find(static_cast<char>(letter));
    if (place == std::string::npos)
    {
      throw VolumeReadingError("its voxels are not base64 text, which they are said to be");
    }
    return static_cast<std::uint32_t>(place);
  }

  std::unique_ptr<ByteStream> Text;
  std::vector<unsigned char> Buffer;
  std::size_t Used = 0;
  std::size_t Filled = 0;
  unsigned char Decoded[3] = { 0, 0, 0 };
  std::size_t DecodedUsed = 0;
  std::size_t DecodedSize = 0;
};

}

std::unique_ptr<ByteStream> DecodeBase64(std::unique_ptr<ByteStream> text)
{
  return std::make_unique<Base64Bytes>(std::move(text));
}

}
