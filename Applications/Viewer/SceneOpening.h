/**
 * @class   SceneOpening
 * @brief   reads scenes in a thread of its own
 *
 * One at a time: another Start() cancels what is being read. The window goes on meanwhile.
 */

#ifndef SceneOpening_h
#define SceneOpening_h

#include "SceneReading.h"
#include "SeriesList.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace penumbra
{

using SeriesChoice = std::vector<SeriesFacts>;

class SceneOpening : public QObject
{
  Q_OBJECT
public:
  /// `dicomParser` is the program penumbra-dicom-parser.
  explicit SceneOpening(std::filesystem::path dicomParser, QObject* parent = nullptr);
  ~SceneOpening() override;

  void Start(const OpenRequest& request);

  /// Ends what is being read, with canceled().
  void Cancel();

  bool IsReading() const { return this->Current != nullptr; }

signals:
  /// How much is read, 0 to 1.
  void progressed(double part);
  void opened(std::shared_ptr<const OpenedScene> scene);
  /// One line that says what is wrong.
  void failed(const QString& file, const QString& reason);
  void canceled();
  /// The folder of the request holds several series; nothing was read.
  void seriesFound(const penumbra::OpenRequest& request, const penumbra::SeriesChoice& series);

private:
  struct Task
  {
    OpenRequest Request;
    std::atomic<bool> Canceled{ false };
  };

  /// These two run in the thread.
  ///@{
  void Read(const std::shared_ptr<Task>& task);
  bool FindSeveralSeries(const std::shared_ptr<Task>& task, const VoxelReading& reading);
  ///@}
  void Finish(const std::shared_ptr<Task>& task, const std::shared_ptr<OpenedScene>& scene,
    const QString& reason);
  void OfferSeries(const std::shared_ptr<Task>& task, const SeriesChoice& series);
  void Tell(const std::shared_ptr<Task>& task, double part);

  std::filesystem::path DicomParser;
  std::shared_ptr<Task> Current;
  std::thread Thread;
};

}

#endif
