/**
 * @class   PropertyForm
 * @brief   rows of controls, each for one value of the document's scene
 *
 * Every row says how its value is read from a scene and how it is put into one; showing, editing,
 * undo, names for screen readers and tool tips come with it.
 */

#ifndef PropertyForm_h
#define PropertyForm_h

#include "NumberBox.h"
#include "SceneDescription.h"

#include <QStringList>
#include <QWidget>

#include <functional>
#include <vector>

class QFormLayout;

namespace penumbra
{

class SceneDocument;

/// What a control is called, and what it does to the picture.
struct PropertyText
{
  QString Label;
  QString Tip;
};

template <typename Value>
struct PropertyAccess
{
  std::function<Value(const SceneDescription&)> Get;
  std::function<void(SceneDescription&, const Value&)> Set;
};

class PropertyForm : public QWidget
{
  Q_OBJECT
public:
  using Condition = std::function<bool(const SceneDescription&)>;

  explicit PropertyForm(SceneDocument* document, QWidget* parent = nullptr);

  /// With a slider up to `slideTo`.
  void AddSlider(const PropertyText& text, const NumberRange& range, double slideTo,
    const PropertyAccess<double>& access);
  void AddNumber(
    const PropertyText& text, const NumberRange& range, const PropertyAccess<double>& access);
  /// The value is the index of the choice.
  void AddChoice(
    const PropertyText& text, const QStringList& choices, const PropertyAccess<int>& access);
  void AddSwitch(const PropertyText& text, const PropertyAccess<bool>& access);
  void AddColor(const PropertyText& text, const PropertyAccess<Vector3>& access);
  void AddVector(
    const PropertyText& text, const NumberRange& range, const PropertyAccess<Vector3>& access);
  void AddText(const PropertyText& text, const PropertyAccess<QString>& access);
  void AddWidget(QWidget* widget);
  /// Above the rows that follow.
  void AddHeading(const QString& text);

  /// The row added last is shown only where this holds.
  void ShowLastWhen(const Condition& condition);

  /// No value is read where this does not hold; the form is then disabled.
  void EnableWhen(const Condition& condition) { this->Enabled = condition; }

  void Refresh();

private:
  struct Row
  {
    QWidget* Label;
    QWidget* Field;
    std::function<void(const SceneDescription&)> Show;
    Condition Shown;
  };

  void AddRow(const PropertyText& text, QWidget* field,
    const std::function<void(const SceneDescription&)>& show);
  template <typename Value>
  void Edit(const PropertyText& text, const PropertyAccess<Value>& access, const Value& value,
    bool gesture);

  SceneDocument* Document;
  QFormLayout* Layout;
  std::vector<Row> Rows;
  Condition Enabled;
};

}

#endif
