#include "DicomParserProgram.h"

#include "DicomDirectory.h"
#include "DicomMessages.h"
#include "DicomVoxels.h"
#include "FailureReason.h"
#include "LocalDicomParser.h"
#include "SharedMemory.h"
#include "vtkAbstractArray.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <mutex>
#include <optional>

using nlohmann::json;

namespace penumbra
{

namespace
{

// By several threads.
void Send(const json& message)
{
  static std::mutex oneAtATime;
  const std::lock_guard<std::mutex> lock(oneAtATime);
  const std::string bytes = Encode(message);
  std::fwrite(bytes.data(), 1, bytes.size(), stdout);
  std::fflush(stdout);
}

// Nothing where no more is asked for.
std::optional<DicomRequest> ReceiveRequest()
{
  std::string bytes;
  for (int byte = std::getchar(); byte != EOF; byte = std::getchar())
  {
    bytes += static_cast<char>(byte);
    if (const auto message = TakeMessage(bytes))
    {
      return RequestFromMessage(*message);
    }
  }
  return std::nullopt;
}

void SendHeaders(const DicomRequest& request)
{
  for (std::size_t index = 0; index < request.files.size(); ++index)
  {
    const double progress = static_cast<double>(index) / static_cast<double>(request.files.size());
    Send({ { DicomAnswer::Start, index }, { DicomAnswer::Progress, progress } });
    const DicomHeaderResult result = TryReadDicomHeader(request.files[index].path);
    const DicomImage* image = std::get_if<DicomImage>(&result);
    Send(image ? json{ { DicomAnswer::Image, ToMessage(*image) } }
               : json{ { DicomAnswer::Failure, std::get<std::string>(result) } });
  }
}

void SendDirectory(const DicomRequest& request)
{
  Send({ { DicomAnswer::Start, 0 }, { DicomAnswer::Progress, 0.0 } });
  try
  {
    json files = json::array();
    for (const auto& path : ReadDicomDirectory(request.files.at(0).path))
    {
      files.push_back(ToMessage(path));
    }
    Send({ { DicomAnswer::Files, std::move(files) } });
  }
  catch (const std::exception& error)
  {
    Send({ { DicomAnswer::Failure, FailureReason(error) } });
  }
}

void SendVoxels(const DicomRequest& request)
{
  SharedMemory voxels = SharedMemory::OfParent();
  const auto room = [&voxels, &request](int scalarType)
  {
    const auto scalarSize =
      static_cast<std::uint64_t>(vtkAbstractArray::GetDataTypeSize(scalarType));
    voxels.Resize(scalarSize * NumberOfVoxels(request.plan.geometry, scalarSize));
    return voxels.GetData();
  };
  const auto start = [](std::size_t file, double progress) {
    Send({ { DicomAnswer::Start, file }, { DicomAnswer::Progress, progress } });
  };
  try
  {
    const DicomVoxels read =
      ReadDicomVoxels(request.files, request.plan, room, { start, request.inParallel });
    Send({ { DicomAnswer::ScalarType, read.scalarType }, { DicomAnswer::Filled, read.filled } });
  }
  catch (const DicomFileError& error)
  {
    Send({ { DicomAnswer::Failure, error.what() }, { DicomAnswer::FailedFile, error.File } });
  }
  catch (const std::exception& error)
  {
    Send({ { DicomAnswer::Failure, FailureReason(error) } });
  }
}

void Answer(const DicomRequest& request)
{
  LimitMemory(request.memoryLimit);
  switch (request.task)
  {
    case DicomTask::Headers:
      SendHeaders(request);
      break;
    case DicomTask::Directory:
      SendDirectory(request);
      break;
    case DicomTask::Voxels:
      SendVoxels(request);
      break;
  }
  Send({ { DicomAnswer::Done, true } });
}

}

int RunDicomParser(int argc, char*[])
{
  if (argc != 1)
  {
    std::cerr << "This program reads DICOM files for other programs and is started by them.\n";
    return EXIT_FAILURE;
  }
  std::cout.rdbuf(nullptr); // stdout is for answers alone
  try
  {
    while (const auto request = ReceiveRequest())
    {
      Answer(*request);
    }
    return EXIT_SUCCESS;
  }
  catch (const std::exception&)
  {
    return EXIT_FAILURE; // what was asked for makes no sense
  }
}

}
