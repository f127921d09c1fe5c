#include "SceneOpening.h"

#include <QMetaObject>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace penumbra
{

//------------------------------------------------------------------------------
SceneOpening::SceneOpening(std::filesystem::path dicomParser, QObject* parent)
  : QObject(parent)
  , DicomParser(std::move(dicomParser))
{
}

//------------------------------------------------------------------------------
SceneOpening::~SceneOpening()
{
  this->Cancel();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

//------------------------------------------------------------------------------
void SceneOpening::Start(const OpenRequest& request)
{
  this->Cancel();
  this->Current = std::make_shared<Task>();
  this->Current->Request = request;
  // What was canceled ends when it next asks; the window does not wait for it.
  this->Thread = std::thread(
    [this, task = this->Current](std::thread before)
    {
      if (before.joinable())
      {
        before.join();
      }
      this->Read(task);
    },
    std::move(this->Thread));
}

//------------------------------------------------------------------------------
void SceneOpening::Cancel()
{
  if (!this->Current)
  {
    return;
  }
  this->Current->Canceled = true;
  this->Current.reset();
  emit canceled();
}

//------------------------------------------------------------------------------
void SceneOpening::Read(const std::shared_ptr<Task>& task)
{
  // Where a folder is read after its series were listed, it goes on from where it was.
  double most = 0.0;
  const auto progress = [this, &task, &most](double part)
  {
    most = std::max(most, part);
    QMetaObject::invokeMethod(
      this, [this, task, most] { this->Tell(task, most); }, Qt::QueuedConnection);
    return !task->Canceled;
  };
  const VoxelReading reading = { this->DicomParser, progress };
  std::shared_ptr<OpenedScene> scene;
  QString reason;
  try
  {
    if (task->Request.AskForSeries && !task->Canceled && this->FindSeveralSeries(task, reading))
    {
      return;
    }
    scene = std::make_shared<OpenedScene>(ReadScene(task->Request, reading));
  }
  catch (const std::bad_alloc&)
  {
    reason = tr("There is not enough memory for it.");
  }
  catch (const std::exception& error)
  {
    reason = QString::fromUtf8(error.what());
  }
  QMetaObject::invokeMethod(
    this, [=] { this->Finish(task, scene, reason); }, Qt::QueuedConnection);
}

//------------------------------------------------------------------------------
bool SceneOpening::FindSeveralSeries(const std::shared_ptr<Task>& task, const VoxelReading& reading)
{
  const SeriesChoice series = ListSeries(task->Request.File, reading);
  if (series.size() > 1)
  {
    QMetaObject::invokeMethod(
      this, [=] { this->OfferSeries(task, series); }, Qt::QueuedConnection);
  }
  return series.size() > 1;
}

//------------------------------------------------------------------------------
void SceneOpening::OfferSeries(const std::shared_ptr<Task>& task, const SeriesChoice& series)
{
  if (task == this->Current)
  {
    this->Current.reset();
    emit this->seriesFound(task->Request, series);
  }
}

//------------------------------------------------------------------------------
void SceneOpening::Tell(const std::shared_ptr<Task>& task, double part)
{
  if (task == this->Current)
  {
    emit progressed(part);
  }
}

//------------------------------------------------------------------------------
void SceneOpening::Finish(const std::shared_ptr<Task>& task,
  const std::shared_ptr<OpenedScene>& scene, const QString& reason)
{
  if (task != this->Current)
  {
    return; // canceled
  }
  this->Current.reset();
  if (scene)
  {
    emit opened(scene);
  }
  else
  {
    emit failed(QString::fromStdString(task->Request.File.u8string()), reason);
  }
}

}
