#include "DicomVoxels.h"

#include "DicomPixels.h"
#include "DicomScalars.h"
#include "FailureReason.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace penumbra
{

namespace
{

constexpr std::size_t None = std::numeric_limits<std::size_t>::max();

// Decodes files one after the other and keeps the last, whose other frames are likely to follow.
class FileDecoder
{
public:
  FileDecoder(const std::vector<DicomFile>& files, const FileStart& start)
    : Files(files)
    , Start(start)
  {
  }

  const DicomPixels& Decode(std::size_t file, double progress)
  {
    this->Start(file, progress);
    if (file != this->Current)
    {
      this->Current = None;
      this->Pixels = {};
      this->Pixels = this->ReadPixels(file);
      this->Current = file;
    }
    return this->Pixels;
  }

private:
  DicomPixels ReadPixels(std::size_t file) const
  {
    try
    {
      return ReadDicomPixels(this->Files[file].path, this->Files[file].image);
    }
    catch (const std::exception& error)
    {
      throw DicomFileError(file, FailureReason(error));
    }
  }

  const std::vector<DicomFile>& Files;
  const FileStart& Start;
  std::size_t Current = None;
  DicomPixels Pixels;
};

// Scanned slices go straight to their place in the volume, or wait aside where they have none.
template <typename Scalar>
class SliceAssembler
{
public:
  SliceAssembler(const std::vector<DicomFile>& files, const DicomVolumePlan& plan,
    const DicomValues& values, const FileStart& start, Scalar* voxels)
    : Files(files)
    , Plan(plan)
    , Start(start)
    , Decoder(files, start)
    , Voxels(voxels)
    , SliceSize(static_cast<std::size_t>(plan.geometry.dimensions[0]) *
        static_cast<std::size_t>(plan.geometry.dimensions[1]))
    , Marker(PaddingMarker<Scalar>(values))
    , Places(plan.sources.size(), None)
    , Decoded(plan.sources.size(), nullptr)
  {
    for (std::size_t slice = 0; slice < plan.slices.size(); ++slice)
    {
      if (plan.slices[slice].weight == 0.0)
      {
        this->Places[plan.slices[slice].below] = slice;
      }
    }
  }

  // Decodes by several threads what has a place in the volume; each file is decoded once only if it
  // has one slice. Returns false where Scalar does not hold all values.
  bool DecodeInParallel()
  {
    std::atomic<bool> isHeld{ true };
    std::atomic<bool> hasFailed{ false };
    std::exception_ptr failure;
    const auto decode = [&](vtkIdType begin, vtkIdType end)
    {
      FileDecoder decoder(this->Files, this->Start);
      for (auto source = static_cast<std::size_t>(begin);
           source < static_cast<std::size_t>(end) && isHeld && !hasFailed; ++source)
      {
        try
        {
          if (this->Places[source] != None && !this->Decode(source, decoder))
          {
            isHeld = false;
          }
        }
        catch (...) // no thread but this one's caller may see it
        {
          if (!hasFailed.exchange(true))
          {
            failure = std::current_exception();
          }
        }
      }
    };
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Plan.sources.size()), decode);
    if (failure)
    {
      std::rethrow_exception(failure);
    }
    return isHeld;
  }

  // Returns the number of voxels without a measurement that have got a value, or nothing where
  // Scalar does not hold all values.
  std::optional<std::size_t> Assemble()
  {
    for (std::size_t slice = 0; slice < this->Plan.slices.size(); ++slice)
    {
      const DicomVolumeSlice& of = this->Plan.slices[slice];
      const Scalar* below = this->Decode(of.below, this->Decoder);
      const Scalar* above = of.weight == 0.0 ? below : this->Decode(of.above, this->Decoder);
      if (!below || !above)
      {
        return std::nullopt;
      }
      Scalar* const result = this->Voxels + slice * this->SliceSize;
      if (of.weight != 0.0)
      {
        this->Blend(below, above, of.weight, result);
      }
      else if (below != result)
      {
        std::copy_n(below, this->SliceSize, result);
      }
      this->Aside.erase(this->Aside.begin(), this->Aside.lower_bound(of.below));
    }
    const std::size_t count = this->SliceSize * this->Plan.slices.size();
    return this->HasPadding ? FillPadding(this->Marker, this->Voxels, count) : 0;
  }

private:
  // Null where Scalar does not hold the values.
  const Scalar* Decode(std::size_t source, FileDecoder& decoder)
  {
    if (this->Decoded[source])
    {
      return this->Decoded[source];
    }
    const DicomSource& of = this->Plan.sources[source];
    const double progress =
      static_cast<double>(this->Started++) / static_cast<double>(this->Plan.sources.size());
    const DicomPixels& pixels = decoder.Decode(of.file, progress);
    Scalar* values = this->RoomFor(source);
    const DicomConversion conversion =
      ConvertFrame(pixels, this->Files[of.file].image, of.frame, this->Marker, values);
    if (conversion.hasPadding)
    {
      this->HasPadding = true;
    }
    this->Decoded[source] = conversion.isHeld ? values : nullptr;
    return this->Decoded[source];
  }

  Scalar* RoomFor(std::size_t source)
  {
    if (this->Places[source] != None)
    {
      return this->Voxels + this->Places[source] * this->SliceSize;
    }
    std::vector<Scalar>& aside = this->Aside[source];
    aside.resize(this->SliceSize);
    return aside.data();
  }

  bool IsMarker(Scalar value) const
  {
    return this->Marker && (value == *this->Marker || value != value);
  }

  void Blend(const Scalar* below, const Scalar* above, double weight, Scalar* result) const
  {
    for (std::size_t voxel = 0; voxel < this->SliceSize; ++voxel)
    {
      if (this->IsMarker(below[voxel]) || this->IsMarker(above[voxel]))
      {
        result[voxel] = *this->Marker;
        continue;
      }
      const double value = (1.0 - weight) * static_cast<double>(below[voxel]) +
        weight * static_cast<double>(above[voxel]);
      result[voxel] =
        static_cast<Scalar>(std::numeric_limits<Scalar>::is_integer ? std::round(value) : value);
    }
  }

  const std::vector<DicomFile>& Files;
  const DicomVolumePlan& Plan;
  const FileStart& Start;
  FileDecoder Decoder;
  Scalar* Voxels;
  std::size_t SliceSize;
  std::optional<Scalar> Marker;
  std::atomic<bool> HasPadding{ false };
  std::atomic<std::size_t> Started{ 0 };
  std::vector<std::size_t> Places;
  std::vector<const Scalar*> Decoded;
  std::map<std::size_t, std::vector<Scalar>> Aside;
};

DicomValues ValuesOf(const std::vector<DicomFile>& files, const DicomVolumePlan& plan)
{
  std::vector<DicomImageFrame> slices;
  for (const DicomSource& source : plan.sources)
  {
    slices.emplace_back(&files[source.file].image, source.frame);
  }
  return SummarizeValues(slices);
}

bool HasOneSlicePerFile(const DicomVolumePlan& plan)
{
  std::set<std::size_t> seen;
  return std::all_of(plan.sources.begin(), plan.sources.end(),
    [&seen](const DicomSource& source) { return seen.insert(source.file).second; });
}

template <typename Scalar>
std::optional<std::size_t> Assemble(const std::vector<DicomFile>& files,
  const DicomVolumePlan& plan, const DicomValues& values, const DicomDecoding& decoding,
  void* voxels)
{
  auto* const scalars = static_cast<Scalar*>(voxels);
  SliceAssembler<Scalar> assembler(files, plan, values, decoding.start, scalars);
  const bool inParallel = decoding.inParallel && HasOneSlicePerFile(plan);
  return !inParallel || assembler.DecodeInParallel() ? assembler.Assemble() : std::nullopt;
}

std::optional<std::size_t> AssembleAs(int scalarType, const std::vector<DicomFile>& files,
  const DicomVolumePlan& plan, const DicomValues& values, const DicomDecoding& decoding,
  void* voxels)
{
  switch (scalarType)
  {
    case VTK_UNSIGNED_CHAR:
      return Assemble<std::uint8_t>(files, plan, values, decoding, voxels);
    case VTK_SIGNED_CHAR:
      return Assemble<std::int8_t>(files, plan, values, decoding, voxels);
    case VTK_UNSIGNED_SHORT:
      return Assemble<std::uint16_t>(files, plan, values, decoding, voxels);
    case VTK_SHORT:
      return Assemble<std::int16_t>(files, plan, values, decoding, voxels);
    case VTK_UNSIGNED_INT:
      return Assemble<std::uint32_t>(files, plan, values, decoding, voxels);
    case VTK_INT:
      return Assemble<std::int32_t>(files, plan, values, decoding, voxels);
    case VTK_FLOAT:
      return Assemble<float>(files, plan, values, decoding, voxels);
    default:
      return Assemble<double>(files, plan, values, decoding, voxels);
  }
}

}

DicomVoxels ReadDicomVoxels(const std::vector<DicomFile>& files, const DicomVolumePlan& plan,
  const VoxelRoom& room, const DicomDecoding& decoding)
{
  const DicomValues values = ValuesOf(files, plan);
  for (const int type : PossibleScalarTypes(values))
  {
    const auto filled = AssembleAs(type, files, plan, values, decoding, room(type));
    if (filled)
    {
      return { type, *filled };
    }
  }
  throw VolumeReadingError("its values are too large for any scalar type");
}

}
