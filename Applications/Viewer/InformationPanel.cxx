#include "InformationPanel.h"

#include "ScalarTypes.h"
#include "SceneDocument.h"
#include "VolumeFields.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include <vtkImageData.h>

#include <cmath>

namespace penumbra
{
namespace
{
QLabel* MakeLabel(QWidget* parent)
{
  auto* const label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  return label;
}

QString Number(double number)
{
  return QString::number(number, 'g', std::abs(number) < 1000.0 ? 4 : 6);
}

QString Product(double x, double y, double z)
{
  const QString times = QString::fromUtf8("\u2009\u00d7\u2009"); // between thin spaces
  return QStringList{ Number(x), Number(y), Number(z) }.join(times);
}

QString RowOf(const QString& name, const QString& value)
{
  return QString("<tr><td style='padding-right:6px; color:gray'>%1</td><td>%2</td></tr>")
    .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
}

QString FactsOf(vtkImageData* image, const SceneDescription& scene)
{
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double* range = image->GetScalarRange();
  const QString units = QString::fromStdString(TextField(image, "Units"));
  const QString modality = QString::fromStdString(TextField(image, "Modality"));
  const double mebibytes = image->GetActualMemorySize() / 1024.0;
  // Of what the readers tell, only DICOM's lengths are known.
  const QString lengths = modality.isEmpty() ? QString() : QObject::tr(" mm");
  QString rows =
    RowOf(QObject::tr("File"), QString::fromStdString(scene.Volume.File.filename().u8string()));
  if (!modality.isEmpty())
  {
    rows += RowOf(QObject::tr("Modality"), modality);
  }
  rows += RowOf(QObject::tr("Voxels"), Product(dimensions[0], dimensions[1], dimensions[2]));
  rows += RowOf(QObject::tr("Spacing"), Product(spacing[0], spacing[1], spacing[2]) + lengths);
  rows += RowOf(QObject::tr("Size"),
    Product(spacing[0] * dimensions[0], spacing[1] * dimensions[1], spacing[2] * dimensions[2]) +
      lengths);
  rows += RowOf(QObject::tr("Values"),
    QObject::tr("%1 to %2 %3").arg(Number(range[0]), Number(range[1]), units).trimmed());
  rows += RowOf(QObject::tr("Type"), ScalarTypeName(image->GetScalarType()));
  rows +=
    RowOf(QObject::tr("Memory"), QObject::tr("%1 MiB").arg(QString::number(mebibytes, 'f', 1)));
  return "<table>" + rows + "</table>";
}
}

//------------------------------------------------------------------------------
InformationPanel::InformationPanel(SceneDocument* document, QWidget* parent)
  : QWidget(parent)
  , Document(document)
  , Facts(MakeLabel(this))
  , Notes(MakeLabel(this))
{
  this->Facts->setObjectName("volumeFacts");
  this->Facts->setAccessibleName(tr("Facts about the volume"));
  this->Notes->setAccessibleName(tr("Notes on the volume"));
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(9, 9, 2, 9);
  layout->addWidget(this->Facts);
  layout->addWidget(this->Notes);
  layout->addStretch();
  this->Facts->setText(tr("Nothing is open yet."));
  this->connect(document, &SceneDocument::opened, this, &InformationPanel::Refresh);
}

//------------------------------------------------------------------------------
void InformationPanel::ShowNotes(const QStringList& notes)
{
  this->Notes->setTextFormat(Qt::PlainText);
  this->Notes->setText(notes.join("\n\n"));
}

//------------------------------------------------------------------------------
void InformationPanel::Refresh()
{
  this->Facts->setText(FactsOf(this->Document->GetVoxels().Volume, this->Document->GetScene()));
}

}
