/**
 * @file NiftiSample.h
 * @brief NIfTI files of the sample volume, field by field.
 */
#ifndef NiftiSample_h
#define NiftiSample_h

#include "SampleVolume.h"

#include <array>

struct NiftiSample
{
  bool bigEndian = false;
  int version = 1;
  std::array<short, 8> dim{ 3, 3, 4, 5, 1, 1, 1, 1 };
  std::array<double, 8> pixdim{ 1, 2, 3, 4, 1, 1, 1, 1 };
  short datatype = 4;
  short bitpix = 16;
  double offset = 0.0;
  double slope = 0.0;
  double intercept = 0.0;
  short qformCode = 0;
  short sformCode = 0;
  std::array<double, 3> quaternion{};
  std::array<double, 3> qOffset{};
  std::array<double, 12> sform{};

  /// Header, four bytes without meaning and the voxels.
  std::string File(const std::string& voxels) const
  {
    return this->version == 1 ? this->Header<float>(348) + voxels
                              : this->Header<double>(540) + voxels;
  }

private:
  template <typename Value>
  void Put(std::string& header, std::size_t position, Value value) const
  {
    header.replace(position, sizeof(Value), Bytes(value, this->bigEndian));
  }

  template <typename Real, typename Values>
  void PutAll(std::string& header, std::size_t position, const Values& values) const
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->Put(header, position + i * sizeof(Real), static_cast<Real>(values[i]));
    }
  }

  template <typename Real>
  std::string Header(int size) const
  {
    const bool first = this->version == 1;
    std::string header(size + 4, '\0');
    this->Put(header, 0, size);
    header.replace(
      first ? 344 : 4, first ? 4 : 8, first ? "n+1" : "n+2\0\r\n\x1a\n", first ? 4 : 8);
    first ? this->PutAll<short>(header, 40, this->dim)
          : this->PutAll<long long>(header, 16, this->dim);
    this->Put(header, first ? 70 : 12, this->datatype);
    this->Put(header, first ? 72 : 14, this->bitpix);
    this->PutAll<Real>(header, first ? 76 : 104, this->pixdim);
    const double start = this->offset == 0.0 ? size + 4 : this->offset;
    first ? this->Put(header, 108, static_cast<float>(start))
          : this->Put(header, 168, static_cast<long long>(start));
    this->Put(header, first ? 112 : 176, static_cast<Real>(this->slope));
    this->Put(header, first ? 116 : 184, static_cast<Real>(this->intercept));
    first ? this->Put(header, 252, this->qformCode) : this->Put<int>(header, 344, this->qformCode);
    first ? this->Put(header, 254, this->sformCode) : this->Put<int>(header, 348, this->sformCode);
    this->PutAll<Real>(header, first ? 256 : 352, this->quaternion);
    this->PutAll<Real>(header, first ? 268 : 376, this->qOffset);
    this->PutAll<Real>(header, first ? 280 : 400, this->sform);
    return header;
  }
};

#endif
