#include "StartPage.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace penumbra
{
namespace
{
constexpr int MostRecent = 5;
constexpr int Width = 480;
constexpr int WidestRecent = Width - 30;

QLabel* MakeText(const QString& text, double scale, bool bold, QWidget* parent)
{
  auto* const label = new QLabel(text, parent);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * scale);
  font.setBold(bold);
  label->setFont(font);
  label->setWordWrap(true);
  return label;
}
}

//------------------------------------------------------------------------------
StartPage::StartPage(QWidget* parent)
  : QWidget(parent)
{
  this->setObjectName("startPage");
  this->setAutoFillBackground(true);
  auto* const layout = new QGridLayout(this);
  layout->setRowStretch(0, 1);
  layout->setRowStretch(2, 2);
  auto* const middle = new QWidget(this);
  middle->setMaximumWidth(Width);
  layout->addWidget(middle, 1, 0);
  this->Column = new QVBoxLayout(middle);
  this->Column->setSpacing(6);
  this->Column->addWidget(MakeText(tr("Penumbra"), 2.6, true, middle));
  this->Column->addWidget(MakeText(
    tr("See what lies in front of what: volumes with light and shadow."), 1.1, false, middle));
  this->Column->addSpacing(18);
  QPushButton* folder = this->AddButton(
    tr("Open a &DICOM folder..."), tr("All slices of a CT or MR, as the scanner stored them"));
  QPushButton* file = this->AddButton(tr("Open a &file..."),
    tr("DICOM, MetaImage, NRRD, NIfTI, VTI, RAW, or a scene that was saved"));
  this->Example =
    this->AddButton(tr("Show an &example"), tr("An aortic stent in a CT, lit from the front left"));
  this->Example->hide();
  this->Column->addWidget(
    MakeText(tr("Or drop a file or folder anywhere here."), 1.0, false, middle));
  this->Column->addSpacing(18);
  this->Recent = new QWidget(middle);
  new QVBoxLayout(this->Recent);
  this->Recent->layout()->setContentsMargins(0, 0, 0, 0);
  this->Column->addWidget(this->Recent);
  this->connect(folder, &QPushButton::clicked, this, &StartPage::folderAsked);
  this->connect(file, &QPushButton::clicked, this, &StartPage::fileAsked);
}

//------------------------------------------------------------------------------
QPushButton* StartPage::AddButton(const QString& text, const QString& explanation)
{
  auto* const button = new QPushButton(text, this);
  button->setMinimumHeight(38);
  button->setToolTip(explanation);
  button->setAccessibleDescription(explanation);
  this->Column->addWidget(button);
  return button;
}

//------------------------------------------------------------------------------
void StartPage::SetExample(const QString& file)
{
  this->Example->show();
  this->connect(this->Example, &QPushButton::clicked, this, [=] { emit this->chosen(file); });
}

//------------------------------------------------------------------------------
void StartPage::ShowRecent(const QStringList& files)
{
  qDeleteAll(this->Recent->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
  if (files.isEmpty())
  {
    return;
  }
  this->Recent->layout()->addWidget(MakeText(tr("Recent"), 1.0, true, this->Recent));
  for (const QString& file : files.mid(0, MostRecent))
  {
    const QFileInfo info(file);
    auto* const button = new QPushButton(this->Recent);
    const QString text =
      tr("%1   in %2").arg(info.fileName(), QDir::toNativeSeparators(info.absolutePath()));
    button->setText(
      button->fontMetrics().elidedText(text, Qt::ElideMiddle, WidestRecent).replace("&", "&&"));
    button->setAccessibleName(text);
    button->setFlat(true);
    button->setStyleSheet("text-align: left; padding: 3px;");
    button->setToolTip(file);
    this->connect(button, &QPushButton::clicked, this, [=] { emit this->chosen(file); });
    this->Recent->layout()->addWidget(button);
  }
}

}
