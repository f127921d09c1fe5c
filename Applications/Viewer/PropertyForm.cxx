#include "PropertyForm.h"

#include "ColorButton.h"
#include "NumberSlider.h"
#include "SceneDocument.h"
#include "VectorEdit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

namespace penumbra
{
namespace
{
constexpr int RowHeight = 31;
}

//------------------------------------------------------------------------------
PropertyForm::PropertyForm(SceneDocument* document, QWidget* parent)
  : QWidget(parent)
  , Document(document)
  , Layout(new QFormLayout(this))
{
  this->Layout->setContentsMargins(6, 6, 6, 6);
  this->Layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  this->Layout->setVerticalSpacing(0); // rows that are hidden would keep theirs
  this->setEnabled(false);
  this->connect(document, &SceneDocument::changed, this, &PropertyForm::Refresh);
  this->connect(document, &SceneDocument::lightSelected, this, &PropertyForm::Refresh);
  this->connect(document, &SceneDocument::planeSelected, this, &PropertyForm::Refresh);
}

//------------------------------------------------------------------------------
template <typename Value>
void PropertyForm::Edit(
  const PropertyText& text, const PropertyAccess<Value>& access, const Value& value, bool gesture)
{
  const QString name = tr("change of %1").arg(text.Label.toLower());
  const QString key =
    gesture ? text.Label + QString::number(this->Document->GetSelectedLight()) : QString();
  this->Document->Edit(
    name, [&](SceneDescription& scene) { access.Set(scene, value); }, key);
}

//------------------------------------------------------------------------------
void PropertyForm::AddRow(const PropertyText& text, QWidget* field,
  const std::function<void(const SceneDescription&)>& show)
{
  auto* const label = new QLabel(text.Label, this);
  label->setToolTip(text.Tip);
  label->setBuddy(field);
  if (field->toolTip().isEmpty())
  {
    field->setToolTip(text.Tip);
    field->setAccessibleName(text.Label);
    field->setAccessibleDescription(text.Tip);
    field->setObjectName(text.Label);
  }
  field->setMinimumHeight(RowHeight);
  label->setMinimumHeight(RowHeight);
  this->Layout->addRow(label, field);
  this->Rows.push_back({ label, field, show, {} });
}

//------------------------------------------------------------------------------
void PropertyForm::AddSlider(const PropertyText& text, const NumberRange& range, double slideTo,
  const PropertyAccess<double>& access)
{
  auto* const slider = new NumberSlider(range, slideTo, this);
  slider->SetNames(text.Label, text.Tip);
  this->connect(slider, &NumberSlider::edited, this,
    [=](double value) { this->Edit(text, access, value, true); });
  this->AddRow(
    text, slider, [=](const SceneDescription& scene) { slider->ShowValue(access.Get(scene)); });
}

//------------------------------------------------------------------------------
void PropertyForm::AddNumber(
  const PropertyText& text, const NumberRange& range, const PropertyAccess<double>& access)
{
  auto* const box = new NumberBox(range, this);
  this->connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
    [=](double value) { this->Edit(text, access, value, true); });
  this->AddRow(
    text, box, [=](const SceneDescription& scene) { box->ShowValue(access.Get(scene)); });
}

//------------------------------------------------------------------------------
void PropertyForm::AddChoice(
  const PropertyText& text, const QStringList& choices, const PropertyAccess<int>& access)
{
  auto* const box = new QComboBox(this);
  box->addItems(choices);
  this->connect(box, qOverload<int>(&QComboBox::activated), this,
    [=](int index) { this->Edit(text, access, index, false); });
  this->AddRow(
    text, box, [=](const SceneDescription& scene) { box->setCurrentIndex(access.Get(scene)); });
}

//------------------------------------------------------------------------------
void PropertyForm::AddSwitch(const PropertyText& text, const PropertyAccess<bool>& access)
{
  auto* const box = new QCheckBox(this);
  this->connect(box, &QCheckBox::clicked, this,
    [=](bool checked) { this->Edit(text, access, checked, false); });
  this->AddRow(
    text, box, [=](const SceneDescription& scene) { box->setChecked(access.Get(scene)); });
}

//------------------------------------------------------------------------------
void PropertyForm::AddColor(const PropertyText& text, const PropertyAccess<Vector3>& access)
{
  auto* const button = new ColorButton(this);
  this->connect(button, &ColorButton::edited, this,
    [=](const Vector3& color) { this->Edit(text, access, color, true); });
  this->AddRow(
    text, button, [=](const SceneDescription& scene) { button->ShowColor(access.Get(scene)); });
}

//------------------------------------------------------------------------------
void PropertyForm::AddVector(
  const PropertyText& text, const NumberRange& range, const PropertyAccess<Vector3>& access)
{
  auto* const edit = new VectorEdit(range, this);
  edit->SetNames(text.Label, text.Tip);
  this->connect(edit, &VectorEdit::edited, this,
    [=](const Vector3& vector) { this->Edit(text, access, vector, true); });
  this->AddRow(
    text, edit, [=](const SceneDescription& scene) { edit->ShowVector(access.Get(scene)); });
}

//------------------------------------------------------------------------------
void PropertyForm::AddText(const PropertyText& text, const PropertyAccess<QString>& access)
{
  auto* const line = new QLineEdit(this);
  this->connect(line, &QLineEdit::editingFinished, this,
    [=] { this->Edit(text, access, line->text(), false); });
  this->AddRow(
    text, line, [=](const SceneDescription& scene) { line->setText(access.Get(scene)); });
}

//------------------------------------------------------------------------------
void PropertyForm::AddWidget(QWidget* widget)
{
  this->Layout->addRow(widget);
  this->Rows.push_back({ nullptr, widget, [](const SceneDescription&) {}, {} });
}

//------------------------------------------------------------------------------
void PropertyForm::AddHeading(const QString& text)
{
  auto* const heading = new QLabel(text, this);
  QFont font = heading->font();
  font.setBold(true);
  heading->setFont(font);
  heading->setMinimumHeight(RowHeight);
  heading->setAlignment(Qt::AlignLeft | Qt::AlignBottom);
  this->AddWidget(heading);
}

//------------------------------------------------------------------------------
void PropertyForm::ShowLastWhen(const Condition& condition)
{
  this->Rows.back().Shown = condition;
}

//------------------------------------------------------------------------------
void PropertyForm::Refresh()
{
  const bool enabled =
    this->Document->IsOpen() && (!this->Enabled || this->Enabled(this->Document->GetScene()));
  this->setEnabled(enabled);
  if (!enabled)
  {
    return;
  }
  const SceneDescription& scene = this->Document->GetScene();
  for (const Row& row : this->Rows)
  {
    const bool shown = !row.Shown || row.Shown(scene);
    row.Field->setVisible(shown);
    if (row.Label)
    {
      row.Label->setVisible(shown);
    }
    if (shown)
    {
      row.Show(scene);
    }
  }
}

}
