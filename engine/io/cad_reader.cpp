// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cad_reader.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"

#include "part_builder.hpp"
#include "step_text.hpp"
#include "text_scanner.hpp"
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_BasicEditor.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Check.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDF_Tool.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Iterator.hxx>
#include <UnitsMethods.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>

#include <Quantity_Color.hxx>

#include <algorithm>
#include <istream>
#include <streambuf>

namespace wcam::io {

namespace {

/// Bytes in memory for a stream that ends early after a cancel request.
class MemoryBuffer : public std::streambuf {
public:
  MemoryBuffer(std::string_view bytes, JobContext context)
      : bytes_(bytes), context_(std::move(context)) {
    open(0);
  }

private:
  static constexpr std::size_t kWindow = std::size_t{1} << 20U;

  void open(std::size_t position) {
    // A get area that is never written to.
    char* base = const_cast<char*>(bytes_.data());
    setg(base, base + position, base + std::min(bytes_.size(), position + kWindow));
  }

  int_type underflow() override {
    const std::size_t position = offset();
    if (position >= bytes_.size() || context_.cancelled()) {
      return traits_type::eof();
    }
    context_.report(static_cast<double>(position) / static_cast<double>(bytes_.size()));
    open(position);
    return traits_type::to_int_type(*gptr());
  }

  pos_type seekoff(off_type offset,
                   std::ios_base::seekdir direction,
                   std::ios_base::openmode mode) override {
    const off_type base = direction == std::ios_base::beg   ? off_type(0)
                          : direction == std::ios_base::cur ? off_type(this->offset())
                                                            : off_type(bytes_.size());
    return seekpos(pos_type(base + offset), mode);
  }

  pos_type seekpos(pos_type position, std::ios_base::openmode) override {
    const off_type p = position;
    if (p < 0 || p > off_type(bytes_.size())) {
      return pos_type(off_type(-1));
    }
    open(static_cast<std::size_t>(p));
    return position;
  }

  [[nodiscard]] std::size_t offset() const {
    return static_cast<std::size_t>(gptr() - bytes_.data());
  }

  std::string_view bytes_;
  JobContext context_;
};

/// Once per process: the readers' parameters, lengths in millimetres.
void initialiseReaders() {
  static const bool done = [] {
    STEPControl_Controller::Init();
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    Interface_Static::SetIVal("read.surfacecurve.mode", 0);
    UnitsMethods::SetCasCadeLengthUnit(1.0);
    return true;
  }();
  static_cast<void>(done);
}

std::string nameOf(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) {
    return {};
  }
  const TCollection_ExtendedString& text = attribute->Get();
  std::string utf8(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter buffer = utf8.data();
  utf8.resize(static_cast<std::size_t>(text.ToUTF8CString(buffer)));
  // Names that only repeat the entity's type say nothing.
  static const std::vector<std::string> kTypeNames = {"COMPOUND", "COMPSOLID", "SOLID", "SHELL",
                                                      "FACE",     "WIRE",      "EDGE",  "VERTEX"};
  const bool typeOnly = std::find(kTypeNames.begin(), kTypeNames.end(), utf8) != kTypeNames.end();
  // "=>[0:1:1:2]" is OpenCASCADE's own label for an instance without a name.
  return typeOnly || utf8.starts_with("=>[") ? std::string() : utf8;
}

/// Walks the document: assemblies down to their bodies, each with its placement.
class DocumentWalker {
public:
  explicit DocumentWalker(const Handle(TDocStd_Document) & document)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {}

  void walk(CadModel& model) const {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    for (int i = 1; i <= roots.Length(); ++i) {
      visit(roots.Value(i), TopLoc_Location(), {}, {}, model);
    }
  }

private:
  /// @param location of the parent; `name` and `colour` of the instance that refers to this label
  void visit(const TDF_Label& label,
             const TopLoc_Location& location,
             const std::string& name,
             const std::string& colour,
             CadModel& model) const {
    if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      visitComponents(label, location, model);
      return;
    }
    CadItem body;
    body.shape = XCAFDoc_ShapeTool::GetShape(label).Moved(location);
    const std::string ownName = nameOf(label);
    body.name = ownName.empty() ? name : ownName;
    const std::string ownColour = colourOf(label);
    body.colour = ownColour.empty() ? colour : ownColour;
    collectNamed(label, location, model);
    model.bodies.push_back(std::move(body));
  }

  void visitComponents(const TDF_Label& assembly,
                       const TopLoc_Location& location,
                       CadModel& model) const {
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(assembly, components);
    for (int i = 1; i <= components.Length(); ++i) {
      const TDF_Label component = components.Value(i);
      TDF_Label target;
      if (!XCAFDoc_ShapeTool::GetReferredShape(component, target)) {
        target = component;
      }
      visit(target, location * XCAFDoc_ShapeTool::GetLocation(component), nameOf(component),
            colourOf(component), model);
    }
  }

  void collectNamed(const TDF_Label& label,
                    const TopLoc_Location& location,
                    CadModel& model) const {
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetSubShapes(label, parts);
    for (int i = 1; i <= parts.Length(); ++i) {
      const std::string name = nameOf(parts.Value(i));
      if (!name.empty()) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(parts.Value(i));
        model.named.push_back({shape.Moved(location), name, {}});
      }
    }
  }

  [[nodiscard]] std::string colourOf(const TDF_Label& label) const {
    Quantity_Color colour;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv}) {
      if (colours_->GetColor(label, type, colour)) {
        return Quantity_Color::ColorToHex(colour).ToCString();
      }
    }
    return {};
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
};

[[noreturn]] void cannotRead(const std::filesystem::path& file,
                             const char* format,
                             const OcctSession& session) {
  throw Error(ErrorCode::InputInvalid,
              text("this is no readable %1 file%2", {format, session.messageTail()}),
              pathText(file), "the file is damaged or cut off; export it again");
}

[[noreturn]] void transferFailed(const std::filesystem::path& file,
                                 const char* format,
                                 const OcctSession& session) {
  throw Error(ErrorCode::InputInvalid,
              text("the %1 file has no shape that can be read%2", {format, session.messageTail()}),
              pathText(file), "check the part in the CAD system and export it again");
}

/// Tells of entities whose parameters could not be read. Many files have some (names without
/// quotes), mostly without harm; the shapes that come of the others may lack something.
void tellDamagedEntities(const char* format,
                         const Handle(XSControl_WorkSession) & session,
                         const JobContext& context) {
  const Handle(Interface_InterfaceModel) model = session->Model();
  std::size_t count = 0;
  std::string first;
  for (int i = 1; !model.IsNull() && i <= model->NbEntities(); ++i) {
    const Handle(Interface_Check)& check = model->Check(i, Standard_True);
    if (!check.IsNull() && check->HasFailed() && count++ == 0) {
      const Handle(TCollection_HAsciiString) label = model->StringLabel(model->Value(i));
      first = printableName(label->ToCString()) + ": " + printableName(check->CFail(1));
    }
  }
  if (count > 0) {
    context.add({Severity::Warning,
                 "import.damaged_entities",
                 text("%1 entities of the %2 file break its rules, the first is %3",
                      {std::to_string(count), format, first}),
                 "check that the part is complete",
                 {},
                 {{"count", static_cast<double>(count)}}});
  }
}

void tellEncoding(const RecodedStep& recoded, const JobContext& context) {
  const std::string count = std::to_string(recoded.strings);
  addCounted(context, Severity::Information, "import.names_recoded", recoded.strings,
             recoded.encoding.empty()
                 ? text("%1 texts of the STEP file are in an encoding that is not known; letters "
                        "beyond ASCII in names are replaced",
                        {count})
                 : text("%1 texts of the STEP file are not in an encoding of the standard; they "
                        "were read as %2",
                        {count, recoded.encoding}),
             "check the names of bodies, faces and edges");
}

Handle(TDocStd_Document) newDocument() {
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  XCAFDoc_DocumentTool::Set(document->Main(), Standard_False);
  return document;
}

CadModel readStep(const std::filesystem::path& file,
                  std::string_view bytes,
                  const OcctSession& session,
                  const JobContext& context) {
  STEPCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  reader.SetColorMode(Standard_True);
  reader.SetLayerMode(Standard_False);
  reader.SetPropsMode(Standard_False);
  const std::optional<RecodedStep> recoded = recodeStep(bytes);
  MemoryBuffer buffer(recoded ? std::string_view(recoded->text) : withoutByteOrderMark(bytes),
                      context.portion(0.0, 0.4));
  std::istream stream(&buffer);
  const IFSelect_ReturnStatus status =
      reader.ChangeReader().ReadStream(pathText(file).c_str(), stream);
  context.check();
  if (status != IFSelect_RetDone) {
    cannotRead(file, "STEP", session);
  }
  tellDamagedEntities("STEP", reader.ChangeReader().WS(), context);
  if (recoded) {
    tellEncoding(*recoded, context);
  }
  CadModel model;
  TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
  reader.ChangeReader().FileUnits(lengths, angles, solidAngles);
  if (!lengths.IsEmpty()) {
    model.unit = lengths.First().ToCString();
  }
  Handle(TDocStd_Document) document = newDocument();
  const Handle(OcctProgress) progress = new OcctProgress(context.portion(0.4, 1.0));
  const bool done = reader.Transfer(document, progress->Start());
  context.check();
  if (!done) {
    transferFailed(file, "STEP", session);
  }
  DocumentWalker(document).walk(model);
  return model;
}

CadModel readIges(const std::filesystem::path& file,
                  const OcctSession& session,
                  const JobContext& context) {
  IGESCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  reader.SetColorMode(Standard_True);
  reader.SetLayerMode(Standard_False);
  const IFSelect_ReturnStatus status = reader.ReadFile(pathText(file).c_str());
  context.check();
  if (status != IFSelect_RetDone) {
    cannotRead(file, "IGES", session);
  }
  tellDamagedEntities("IGES", reader.WS(), context);
  CadModel model;
  const IGESData_GlobalSection& global = reader.IGESModel()->GlobalSection();
  model.unit = IGESData_BasicEditor::UnitFlagName(global.UnitFlag());
  model.millimetresPerUnit = global.UnitValue();
  Handle(TDocStd_Document) document = newDocument();
  const Handle(OcctProgress) progress = new OcctProgress(context.portion(0.3, 1.0));
  const bool done = reader.Transfer(document, progress->Start());
  context.check();
  if (!done) {
    transferFailed(file, "IGES", session);
  }
  DocumentWalker(document).walk(model);
  return model;
}

CadModel readBrep(const std::filesystem::path& file,
                  std::string_view bytes,
                  bool binary,
                  const OcctSession& session,
                  const JobContext& context) {
  MemoryBuffer buffer(bytes, context);
  std::istream stream(&buffer);
  // The readers do not look at the state of the stream: in a damaged file they would go on for
  // billions of items that are not there.
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  TopoDS_Shape shape;
  try {
    if (binary) {
      BinTools::Read(shape, stream);
    } else {
      BRepTools::Read(shape, stream, BRep_Builder());
    }
  } catch (const std::ios_base::failure&) {
    context.check();
    cannotRead(file, "BREP", session);
  }
  context.check();
  if (shape.IsNull()) {
    cannotRead(file, "BREP", session);
  }
  CadModel model;
  if (shape.ShapeType() == TopAbs_COMPOUND) {
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      model.bodies.push_back({it.Value(), {}, {}});
    }
  } else {
    model.bodies.push_back({shape, {}, {}});
  }
  return model;
}

}  // namespace

CadModel readCadModel(const std::filesystem::path& file,
                      std::string_view bytes,
                      CadFormat format,
                      const OcctSession& session,
                      const JobContext& context) {
  initialiseReaders();
  switch (format) {
    case CadFormat::Step:
      return readStep(file, bytes, session, context);
    case CadFormat::Iges:
      return readIges(file, session, context);
    case CadFormat::BrepText:
    case CadFormat::BrepBinary:
      return readBrep(file, bytes, format == CadFormat::BrepBinary, session, context);
  }
  throw Error(ErrorCode::Internal, "unknown CAD format");
}

}  // namespace wcam::io
