#include "MainWindow.h"

#include "SceneDocument.h"
#include "SceneOpening.h"
#include "VolumeView.h"

namespace penumbra
{

//------------------------------------------------------------------------------
MainWindow::MainWindow(const std::filesystem::path& dicomParser, QWidget* parent)
  : QMainWindow(parent)
  , Document(new SceneDocument(this))
  , Opening(new SceneOpening(dicomParser, this))
  , View(new VolumeView(this->Document, this))
{
  this->setCentralWidget(this->View);
  this->connect(this->Opening, &SceneOpening::opened, this, &MainWindow::ShowOpened);
}

//------------------------------------------------------------------------------
MainWindow::~MainWindow() = default;

//------------------------------------------------------------------------------
void MainWindow::Open(const std::filesystem::path& file)
{
  this->Opening->Start({ file, {}, this->View->GetPictureSize() });
}

//------------------------------------------------------------------------------
void MainWindow::Save(const std::filesystem::path& file)
{
  this->Document->SetView(this->View->GetCamera(), this->View->GetPictureSize());
  this->Document->Save(file);
}

//------------------------------------------------------------------------------
void MainWindow::ShowOpened(const std::shared_ptr<const OpenedScene>& scene)
{
  this->Document->Open(*scene);
}

}
