#include "SheetCommand.h"

#include "InputError.h"
#include "OutputFile.h"
#include "Picture.h"
#include "ProgramArguments.h"
#include "SheetDescription.h"
#include "SheetPicture.h"

#include <CLI/CLI.hpp>
#include <vtkImageData.h>
#include <vtksys/SystemTools.hxx>

#include <filesystem>
#include <string>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;

// A picture of the sheet that took its place would be lost.
void RefuseToOverwrite(const OutputFile& output, const fs::path& input)
{
  std::error_code ignored;
  if (fs::equivalent(output.GetTarget(), input, ignored))
  {
    throw InputError(input.u8string() + " is read by this command and cannot be written too");
  }
}

void WriteSheet(const fs::path& input, const fs::path& output)
{
  if (vtksys::SystemTools::LowerCase(output.extension().u8string()) != ".png")
  {
    throw InputError("--output is " + output.u8string() + "; accepted: a name that ends in .png");
  }
  OutputFile file("--output", output);
  RefuseToOverwrite(file, input);
  const SheetDescription sheet = LoadSheet(input);
  for (const SheetRow& row : sheet.Rows)
  {
    for (const SheetCell& cell : row.Cells)
    {
      RefuseToOverwrite(file, cell.Picture);
    }
  }
  file.Write(EncodePicture(MakeSheetPicture(sheet), PictureFormat::Png));
  file.Commit();
}
}

//------------------------------------------------------------------------------
void RunSheetCommand(int argc, char* argv[])
{
  CLI::App program(
    "Lays out pictures in a grid, with titles and captions.", "penumbra-contact-sheet");
  program.set_version_flag("--version", "penumbra-contact-sheet " PENUMBRA_VERSION);
  std::string input;
  std::string output;
  program.add_option("SHEET", input, "What the sheet shows (.json)")->type_name("SHEET.json");
  program.add_option("--output", output, "Picture to write: .png")->type_name("FILE");
  if (!ParseArguments(program, argc, argv))
  {
    return;
  }
  if (input.empty() || output.empty())
  {
    throw InputError(std::string(input.empty() ? "no sheet was named" : "no --output was named") +
      "; penumbra-contact-sheet --help tells the usage");
  }
  WriteSheet(fs::u8path(input), fs::u8path(output));
}

}
