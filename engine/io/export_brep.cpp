// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export_brep.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"

#include "occt_session.hpp"
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

namespace wcam::io {

void writeStep(const std::vector<NamedShape>& shapes, const std::filesystem::path& file) {
  const OcctSession session{JobContext()};
  const std::string fileText = pathText(file);
  guardOcct(fileText, "writing the STEP file", JobContext(), [&] {
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    Interface_Static::SetCVal("write.step.unit", "MM");
    const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    for (const NamedShape& item : shapes) {
      const TDF_Label label = tool->AddShape(item.shape, Standard_False);
      TDataStd_Name::Set(label, TCollection_ExtendedString(item.name.c_str(), Standard_True));
    }
    STEPCAFControl_Writer writer;
    writer.SetNameMode(Standard_True);
    writer.SetColorMode(Standard_True);
    if (!writer.Transfer(document, STEPControl_AsIs) ||
        writer.Write(fileText.c_str()) != IFSelect_RetDone) {
      throw Error(ErrorCode::OutputConflict, text("cannot be written%1", {session.messageTail()}),
                  fileText, "check the folder and its permissions");
    }
  });
}

}  // namespace wcam::io
