/**
 * @class   SceneEdit
 * @brief   one step of the history: the scene before and after
 */

#ifndef SceneEdit_h
#define SceneEdit_h

#include "SceneDescription.h"

#include <QElapsedTimer>
#include <QString>
#include <QUndoCommand>

#include <functional>
#include <memory>

namespace penumbra
{

class SceneEdit : public QUndoCommand
{
public:
  using Scene = std::shared_ptr<const SceneDescription>;

  /**
   * `apply` makes a scene the current one. Edits of the same `gesture`, one shortly after the other
   * as a slider gives them, become one; an empty gesture stays alone.
   */
  SceneEdit(const QString& text, const QString& gesture, Scene before, Scene after,
    std::function<void(const Scene&)> apply);

  void undo() override;
  void redo() override;
  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;

private:
  QString Gesture;
  Scene Before;
  Scene After;
  std::function<void(const Scene&)> Apply;
  QElapsedTimer Age;
};

}

#endif
