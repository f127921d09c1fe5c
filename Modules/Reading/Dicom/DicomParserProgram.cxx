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

using nlohmann::json;

namespace penumbra
{

namespace
{

void Send(const json& message)
{
  const std::string bytes = Encode(message);
  std::fwrite(bytes.data(), 1, bytes.size(), stdout);
  std::fflush(stdout);
}

DicomRequest ReceiveRequest(const std::string& name)
{
  SharedMemory memory(name);
  memory.Map();
  std::string bytes(memory.GetData(), memory.GetSize());
  return RequestFromMessage(TakeMessage(bytes).value());
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
  SharedMemory voxels(request.voxels);
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
    const DicomVoxels read = ReadDicomVoxels(request.files, request.plan, room, start);
    Send({ { DicomAnswer::ScalarType, read.scalarType }, { DicomAnswer::Filled, read.filled } });
  }
  catch (const std::exception& error)
  {
    Send({ { DicomAnswer::Failure, FailureReason(error) } });
  }
}

}

int RunDicomParser(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "This program reads DICOM files for other programs and is started by them.\n";
    return EXIT_FAILURE;
  }
  std::cout.rdbuf(nullptr); // stdout is for answers alone
  try
  {
    const DicomRequest request = ReceiveRequest(argv[1]);
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
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}

}
