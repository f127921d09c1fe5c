#include "SceneEdit.h"

#include <utility>

namespace penumbra
{
namespace
{
// Longer than one picture of a gesture takes on a slow machine.
constexpr qint64 LongestPauseInMilliseconds = 1500;
}

//------------------------------------------------------------------------------
SceneEdit::SceneEdit(const QString& text, const QString& gesture, Scene before, Scene after,
  std::function<void(const Scene&)> apply)
  : QUndoCommand(text)
  , Gesture(gesture)
  , Before(std::move(before))
  , After(std::move(after))
  , Apply(std::move(apply))
{
  this->Age.start();
}

//------------------------------------------------------------------------------
void SceneEdit::undo()
{
  this->Apply(this->Before);
}

//------------------------------------------------------------------------------
void SceneEdit::redo()
{
  this->Apply(this->After);
}

//------------------------------------------------------------------------------
int SceneEdit::id() const
{
  return this->Gesture.isEmpty() ? -1 : 1;
}

//------------------------------------------------------------------------------
bool SceneEdit::mergeWith(const QUndoCommand* other)
{
  const auto* const later = static_cast<const SceneEdit*>(other);
  if (later->Gesture != this->Gesture || this->Age.elapsed() > LongestPauseInMilliseconds)
  {
    return false;
  }
  this->After = later->After;
  this->Age.restart();
  return true;
}

}
