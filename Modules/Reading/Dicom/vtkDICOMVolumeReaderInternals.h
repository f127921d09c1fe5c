/**
 * @file    vtkDICOMVolumeReaderInternals.h
 * @brief   what a reader has found, and how it tells what it cannot read
 */

#ifndef vtkDICOMVolumeReaderInternals_h
#define vtkDICOMVolumeReaderInternals_h

#include "DicomVolumeReading.h"
#include "FailureReason.h"
#include "OneLine.h"
#include "vtkDICOMVolumeReader.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <string>

class vtkDICOMVolumeReader::Internals
{
public:
  // Runs `task` and returns whether it came to its end; what is thrown is reported.
  template <typename Task>
  bool Attempt(vtkDICOMVolumeReader* self, const Task& task)
  {
    this->ErrorMessage.clear();
    self->SetErrorCode(vtkErrorCode::NoError);
    try
    {
      task();
      return true;
    }
    catch (const penumbra::ReadingCancelled& cancelled)
    {
      this->ErrorMessage = cancelled.what();
      return false;
    }
    catch (const std::exception& error)
    {
      self->SetErrorCode(vtkErrorCode::FileFormatError);
      this->ErrorMessage = penumbra::FailureReason(error);
    }
    this->ErrorMessage = penumbra::OneLine(this->ErrorMessage);
    vtkErrorWithObjectMacro(self,
      "cannot read " << penumbra::OneLine(self->DescribeInput()) << ": " << this->ErrorMessage);
    return false;
  }

  // Null where there is no such series.
  const penumbra::DicomSeries* GetSeries(int index) const
  {
    const bool isThere = this->Reading && index >= 0 &&
      static_cast<std::size_t>(index) < this->Reading->GetSeries().size();
    return isThere ? &this->Reading->GetSeries()[static_cast<std::size_t>(index)] : nullptr;
  }

  std::optional<penumbra::DicomVolumeReading> Reading;
  std::unique_ptr<penumbra::DicomParser> Parser;
  vtkNew<vtkStringArray> Warnings;
  std::string ErrorMessage;
};

#endif
