#include "ViewerProgram.h"

#include "InputError.h"
#include "MainWindow.h"
#include "OutputFile.h"
#include "RenderingError.h"
#include "SceneDocument.h"
#include "SceneOpening.h"
#include "Theme.h"
#include "ViewerCommand.h"
#include "VolumeView.h"
#include "vtkMessageCollector.h"

#include <QApplication>
#include <QBuffer>
#include <QPixmap>
#include <QSettings>
#include <QSurfaceFormat>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>

namespace penumbra
{
namespace
{
void TellQtMessage(QtMsgType type, const QMessageLogContext&, const QString& message)
{
  if (type == QtFatalMsg)
  {
    std::cerr << "penumbra-viewer: " << message.simplified().toStdString() << std::endl;
    std::_Exit(1);
  }
}

std::string EncodePng(const QPixmap& picture)
{
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "PNG");
  return bytes.toStdString();
}

// Installed beside the program, or in the sources that it was built from.
std::optional<std::filesystem::path> FindExample(const std::filesystem::path& programs)
{
  std::error_code ignored;
  for (const auto& folder :
    { programs / ".." / PENUMBRA_EXAMPLES, std::filesystem::path(PENUMBRA_DATA) })
  {
    if (std::filesystem::exists(folder / "stent.json", ignored))
    {
      return folder / "stent.json";
    }
  }
  return std::nullopt;
}

// The window shows the scene, is saved and closed.
class Screenshot
{
public:
  Screenshot(MainWindow& window, const std::filesystem::path& file)
    : Output("--screenshot", file)
  {
    QObject::connect(window.GetOpening(), &SceneOpening::failed,
      [this](const QString&, const QString& reason)
      {
        this->Reason = reason.toStdString();
        QCoreApplication::quit();
      });
    QObject::connect(
      window.GetView(), &VolumeView::refined, &window,
      [this, &window]
      {
        this->Output.Write(EncodePng(window.grab()));
        this->Done = true;
        QCoreApplication::quit();
      },
      Qt::QueuedConnection);
  }

  void Finish(const vtkMessageCollector* messages)
  {
    if (!this->Reason.empty())
    {
      throw InputError(this->Reason);
    }
    if (!messages->GetErrors().empty())
    {
      throw RenderingError(messages->GetErrors().front());
    }
    if (!this->Done)
    {
      throw RenderingError("the window was closed before its picture was complete");
    }
    this->Output.Commit();
  }

private:
  OutputFile Output;
  std::string Reason;
  bool Done = false;
};
}

//------------------------------------------------------------------------------
void PrepareQt()
{
  qInstallMessageHandler(TellQtMessage);
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setOrganizationName("Penumbra");
  QCoreApplication::setApplicationName("penumbra-viewer");
  QCoreApplication::setApplicationVersion(PENUMBRA_VERSION);
  QGuiApplication::setApplicationDisplayName("Penumbra");
}

//------------------------------------------------------------------------------
void RunViewer(const ViewerCommand& command, int argc, char* argv[], vtkMessageCollector* messages)
{
  PrepareQt();
  QApplication application(argc, argv);
  ApplyTheme(static_cast<Theme>(QSettings().value("theme", 0).toInt()));
  MainWindow window(command.DicomParser);
  window.resize(command.Size[0], command.Size[1]);
  std::optional<Screenshot> screenshot;
  if (command.Screenshot)
  {
    screenshot.emplace(window, *command.Screenshot);
  }
  else
  {
    window.RestoreLayout();
  }
  if (const auto example = FindExample(command.DicomParser.parent_path()))
  {
    window.OfferExample(*example);
  }
  window.show();
  if (command.Input)
  {
    window.Open(*command.Input);
  }
  QApplication::exec();
  if (screenshot)
  {
    screenshot->Finish(messages);
  }
}

}
