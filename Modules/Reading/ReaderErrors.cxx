#include "ReaderErrors.h"

#include "HeaderText.h"
#include "VolumeReadingError.h"

namespace penumbra
{

namespace
{

// VTK writes "ERROR: In FILE, line N", a line end and "CLASS (ADDRESS): TEXT".
std::string TextOf(const char* message)
{
  const std::string text = message == nullptr ? "an error without words" : message;
  const std::size_t start = text.find("): ");
  return Trimmed(start == std::string::npos ? text : text.substr(start + 3));
}

void Listen(vtkObject*, unsigned long event, void* first, void* message)
{
  auto& text = *static_cast<std::string*>(first);
  if (event == vtkCommand::ErrorEvent && text.empty())
  {
    text = TextOf(static_cast<const char*>(message));
  }
}

}

ReaderErrors::ReaderErrors()
{
  this->Listener->SetClientData(&this->First);
  this->Listener->SetCallback(Listen);
}

void ReaderErrors::Observe(vtkObject* object)
{
  if (!object->HasObserver(vtkCommand::ErrorEvent, this->Listener))
  {
    object->AddObserver(vtkCommand::ErrorEvent, this->Listener);
    object->AddObserver(vtkCommand::WarningEvent, this->Listener);
  }
}

void ReaderErrors::ThrowIfAny() const
{
  if (!this->First.empty())
  {
    throw VolumeReadingError("it is damaged; VTK says: " + this->First);
  }
}

}
