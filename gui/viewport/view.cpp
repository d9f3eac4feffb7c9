// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "view.hpp"

#include <vtkActor.h>
#include <vtkAxesActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace wcam::viewport {

namespace {

// Degrees per pixel of the mouse.
constexpr double kTurn = 0.35;

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double norm(const Point& a) {
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

Point scaled(const Point& a, double f) {
  return {a[0] * f, a[1] * f, a[2] * f};
}

Point plus(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Point unit(const Point& a) {
  const double length = norm(a);
  return length > 0.0 ? scaled(a, 1.0 / length) : Point{0, 0, 1};
}

/// Rotation of v about a unit axis (Rodrigues).
Point turned(const Point& v, const Point& axis, double degrees) {
  const double a = degrees * 0.017453292519943295;
  const double dot = v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
  return plus(plus(scaled(v, std::cos(a)), scaled(cross(axis, v), std::sin(a))),
              scaled(axis, dot * (1.0 - std::cos(a))));
}

Point pointOf(const double* p) {
  return {p[0], p[1], p[2]};
}

/// Whether the segment from a point along `arm` meets a box.
bool crosses(const std::array<double, 6>& box, const Point& from, const Point& arm) {
  double low = 0.0;
  double high = 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (arm[i] == 0.0) {
      if (from[i] < box[2 * i] || from[i] > box[2 * i + 1]) {
        return false;
      }
      continue;
    }
    const double a = (box[2 * i] - from[i]) / arm[i];
    const double b = (box[2 * i + 1] - from[i]) / arm[i];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return low <= high;
}

void makeCurrentOf(vtkObject*, unsigned long, void* client, void*) {
  const auto* function = static_cast<std::function<void()>*>(client);
  if (*function) {
    (*function)();
  }
}

/// The context is always made current before this class draws.
void isCurrentOf(vtkObject*, unsigned long, void*, void* call) {
  *static_cast<bool*>(call) = true;
}

void supportsOpenGlOf(vtkObject*, unsigned long, void*, void* call) {
  *static_cast<int*>(call) = 1;
}

}  // namespace

struct View::Impl {
  Scene scene;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> corner;  // the axes
  vtkNew<vtkAxesActor> axes;
  std::function<void()> makeCurrent;
  vtkNew<vtkCallbackCommand> makeCurrentCommand;
  vtkNew<vtkCallbackCommand> isCurrentCommand;
  vtkNew<vtkCallbackCommand> supportsCommand;
  bool ready = false;
  int width = 1;
  int height = 1;
  int inset = 0;
  FrameBudget budget;

  /// Draws what the scene has chosen.
  void draw(bool first, bool last, bool smooth, double triangles);

  [[nodiscard]] vtkCamera* camera() const { return scene.renderer()->GetActiveCamera(); }

  void setCamera(const Point& focal, const Point& eye, const Point& up) {
    camera()->SetFocalPoint(focal.data());
    camera()->SetPosition(eye.data());
    camera()->SetViewUp(up.data());
    camera()->OrthogonalizeViewUp();
  }

  [[nodiscard]] Scene::Ray ray(double x, double y) const {
    Scene::Ray ray;
    const double aspect = static_cast<double>(width) / std::max(height, 1);
    vtkMatrix4x4* matrix = camera()->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
    vtkNew<vtkMatrix4x4> inverse;
    vtkMatrix4x4::Invert(matrix, inverse);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        ray.worldToClip[4 * i + j] = matrix->GetElement(i, j);
      }
    }
    ray.x = x;
    ray.y = height - y;
    ray.width = width;
    ray.height = height;
    const auto unproject = [&](double depth) {
      const double clip[4] = {2.0 * ray.x / width - 1.0, 2.0 * ray.y / height - 1.0, depth, 1.0};
      double world[4];
      inverse->MultiplyPoint(clip, world);
      return Point{world[0] / world[3], world[1] / world[3], world[2] / world[3]};
    };
    ray.eye = unproject(-1.0);
    ray.direction = unit(minus(unproject(1.0), ray.eye));
    return ray;
  }
};

View::View() : impl_(std::make_unique<Impl>()) {
  Impl& d = *impl_;
  d.window->SetReadyForRendering(false);
  d.window->SetFrameBlitModeToNoBlit();
  d.window->SetMultiSamples(0);
  d.window->SetNumberOfLayers(2);
  d.makeCurrentCommand->SetCallback(makeCurrentOf);
  d.makeCurrentCommand->SetClientData(&d.makeCurrent);
  d.isCurrentCommand->SetCallback(isCurrentOf);
  d.supportsCommand->SetCallback(supportsOpenGlOf);
  d.window->AddObserver(vtkCommand::WindowMakeCurrentEvent, d.makeCurrentCommand);
  d.window->AddObserver(vtkCommand::WindowIsCurrentEvent, d.isCurrentCommand);
  d.window->AddObserver(vtkCommand::WindowSupportsOpenGLEvent, d.supportsCommand);
  d.window->AddRenderer(d.scene.renderer());
  d.corner->SetViewport(0.0, 0.0, 0.13, 0.18);
  d.corner->SetLayer(1);
  d.corner->InteractiveOff();
  for (vtkCaptionActor2D* caption :
       {d.axes->GetXAxisCaptionActor2D(), d.axes->GetYAxisCaptionActor2D(),
        d.axes->GetZAxisCaptionActor2D()}) {
    caption->GetTextActor()->SetTextScaleModeToNone();
    caption->GetCaptionTextProperty()->SetFontSize(14);
    caption->GetCaptionTextProperty()->ItalicOff();
    caption->GetCaptionTextProperty()->ShadowOff();
    caption->GetCaptionTextProperty()->SetColor(0.45, 0.5, 0.55);
  }
  d.corner->AddActor(d.axes);
  d.window->AddRenderer(d.corner);
  setStandardView(StandardView::Isometric);
}

View::~View() {
  impl_->makeCurrent = nullptr;
}

Scene& View::scene() {
  return impl_->scene;
}

void View::setMakeCurrent(std::function<void()> makeCurrent) {
  impl_->makeCurrent = std::move(makeCurrent);
}

void View::initializeGl() {
  Impl& d = *impl_;
  d.window->GetState()->Reset();
  d.window->SetOwnContext(0);
  d.window->OpenGLInitContext();
  d.window->OpenGLInit();
  d.window->SetReadyForRendering(true);
  d.ready = true;
  d.scene.addSamples();
  render(Scene::Detail::Fine);
  d.scene.removeSamples();
  d.budget = FrameBudget();
}

void View::releaseGl() {
  if (impl_->ready) {
    impl_->window->Finalize();
    impl_->window->SetReadyForRendering(false);
    impl_->ready = false;
  }
}

bool View::ready() const {
  return impl_->ready;
}

void View::resize(int width, int height) {
  impl_->width = std::max(width, 1);
  impl_->height = std::max(height, 1);
  impl_->window->SetSize(impl_->width, impl_->height);
}

void View::Impl::draw(bool first, bool last, bool smooth, double triangles) {
  const auto start = std::chrono::steady_clock::now();
  vtkOpenGLState* state = window->GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(0x0203);  // GL_LEQUAL
  if (first) {
    // The axes in the corner turn with the camera.
    const Point from =
        unit(minus(pointOf(camera()->GetPosition()), pointOf(camera()->GetFocalPoint())));
    vtkCamera* own = corner->GetActiveCamera();
    own->SetFocalPoint(0, 0, 0);
    own->SetPosition(scaled(from, 5.5).data());
    own->SetViewUp(camera()->GetViewUp());
    corner->ResetCameraClippingRange();
    scene.renderer()->ResetCameraClippingRange();
  }
  scene.renderer()->SetErase(first ? 1 : 0);
  scene.renderer()->SetUseFXAA(last && smooth);
  corner->SetDraw(last ? 1 : 0);
  window->Render();
  window->WaitForCompletion();
  state->Pop();
  budget.drawn(triangles,
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

bool View::fitsOneFrame() const {
  return impl_->scene.triangles(Scene::Detail::Fine) <= impl_->budget.capacity();
}

void View::render(Scene::Detail detail) {
  if (impl_->ready) {
    const double triangles = impl_->scene.chooseAll(detail);
    impl_->draw(true, true, detail == Scene::Detail::Fine, triangles);
  }
}

bool View::renderPortion(bool first) {
  Impl& d = *impl_;
  if (!d.ready) {
    return true;
  }
  if (first) {
    d.scene.beginPortions(d.budget.capacity());
  }
  const double triangles = d.scene.choosePortion(d.budget.capacity());
  d.draw(first, d.scene.portionsComplete(), true, triangles);
  return d.scene.portionsComplete();
}

unsigned View::framebuffer() const {
  return impl_->ready ? impl_->window->GetRenderFramebuffer()->GetFBOIndex() : 0;
}

const FrameBudget& View::budget() const {
  return impl_->budget;
}

void View::orbit(double dx, double dy) {
  Impl& d = *impl_;
  const Point focal = pointOf(d.camera()->GetFocalPoint());
  const Point up = {0, 0, 1};
  Point arm = minus(pointOf(d.camera()->GetPosition()), focal);
  Point viewUp = pointOf(d.camera()->GetViewUp());
  // A turntable: sideways about the vertical, up and down about the screen's horizontal.
  arm = turned(arm, up, -kTurn * dx);
  viewUp = turned(viewUp, up, -kTurn * dx);
  const Point right = unit(cross(viewUp, arm));
  const Point tilted = turned(arm, right, -kTurn * dy);
  // Never over the poles.
  const double limit = 0.9995 * norm(tilted);
  if (std::abs(tilted[2]) < limit || std::abs(tilted[2]) < std::abs(arm[2])) {
    arm = tilted;
    viewUp = turned(viewUp, right, -kTurn * dy);
  }
  d.setCamera(focal, plus(focal, arm), viewUp);
}

void View::pan(double dx, double dy) {
  Impl& d = *impl_;
  vtkCamera* camera = d.camera();
  const Point focal = pointOf(camera->GetFocalPoint());
  const Point arm = minus(pointOf(camera->GetPosition()), focal);
  const Point up = unit(pointOf(camera->GetViewUp()));
  const Point right = unit(cross(up, arm));
  const double height =
      camera->GetParallelProjection() != 0
          ? 2.0 * camera->GetParallelScale()
          : 2.0 * norm(arm) * std::tan(0.5 * camera->GetViewAngle() * 0.017453292519943295);
  const double scale = height / d.height;
  const Point move = plus(scaled(right, -dx * scale), scaled(up, dy * scale));
  d.setCamera(plus(focal, move), plus(plus(focal, arm), move), up);
}

void View::zoom(double factor, double x, double y) {
  Impl& d = *impl_;
  vtkCamera* camera = d.camera();
  // What is under the mouse stays there.
  const double middle = 0.5 * d.width * (1.0 - camera->GetWindowCenter()[0]);
  pan(middle - x, 0.5 * d.height - y);
  if (camera->GetParallelProjection() != 0) {
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  } else {
    const Point focal = pointOf(camera->GetFocalPoint());
    const Point arm = minus(pointOf(camera->GetPosition()), focal);
    d.setCamera(focal, plus(focal, scaled(arm, 1.0 / factor)), pointOf(camera->GetViewUp()));
  }
  pan(x - middle, y - 0.5 * d.height);
}

void View::setStandardView(StandardView view) {
  Impl& d = *impl_;

  struct Direction {
    Point from;
    Point up;
  };

  static constexpr std::array<Direction, 7> kDirections = {{{{0.62, -0.75, 0.48}, {0, 0, 1}},
                                                            {{0, -1, 0}, {0, 0, 1}},
                                                            {{0, 1, 0}, {0, 0, 1}},
                                                            {{-1, 0, 0}, {0, 0, 1}},
                                                            {{1, 0, 0}, {0, 0, 1}},
                                                            {{0, 0, 1}, {0, 1, 0}},
                                                            {{0, 0, -1}, {0, 1, 0}}}};
  const Direction& direction = kDirections[static_cast<std::size_t>(view)];
  const Point focal = pointOf(d.camera()->GetFocalPoint());
  const double distance = d.camera()->GetDistance();
  d.setCamera(focal, plus(focal, scaled(unit(direction.from), distance)), direction.up);
  fit();
}

void View::fit() {
  const std::array<double, 6> box = impl_->scene.bounds();
  if (box[0] <= box[1]) {
    Impl& d = *impl_;
    // The middle of the picture goes to the middle of what is free, and a narrow view holds less.
    const double free = std::max(d.width - d.inset, d.width / 2);
    const auto shape = [&d](double width) { return std::min(width / d.height, 1.0); };
    d.camera()->SetWindowCenter(free / d.width - 1.0, 0.0);
    d.scene.renderer()->ResetCamera(box.data());
    d.camera()->Zoom(1.08 * shape(free) / shape(d.width));
    if (impl_->camera()->GetParallelProjection() == 0) {
      // Zoom() narrows the angle; the same by coming nearer, so that the perspective stays.
      const double angle = impl_->camera()->GetViewAngle();
      impl_->camera()->SetViewAngle(30.0);
      impl_->camera()->Dolly(30.0 / angle);
    }
  }
}

void View::setInset(int left) {
  impl_->inset = std::max(left, 0);
}

void View::setParallel(bool on) {
  impl_->camera()->SetParallelProjection(on ? 1 : 0);
  fit();
}

bool View::parallel() const {
  return impl_->camera()->GetParallelProjection() != 0;
}

void View::lookAt(const Point& target) {
  Impl& d = *impl_;
  const Point arm = minus(pointOf(d.camera()->GetPosition()), pointOf(d.camera()->GetFocalPoint()));
  const Point up = pointOf(d.camera()->GetViewUp());
  const auto boxes = d.scene.obstacles(target);
  const Point right = unit(cross(Point{0, 0, 1}, arm));
  // Azimuths to both sides, from a little higher, then from far above.
  constexpr double kTurnStep = 20.0;
  constexpr double kLifts[] = {0.0, 25.0, 50.0};
  const Point* best = nullptr;
  Point tried;
  for (const double lift : kLifts) {
    for (int k = 0; k <= 18 && best == nullptr; ++k) {
      // 0, 1, −1, 2, −2, …
      const int steps = (k + 1) / 2;
      const double turn = kTurnStep * (k % 2 == 1 ? steps : -steps);
      tried = turned(turned(arm, right, -lift), {0, 0, 1}, turn);
      const bool overThePole = std::abs(tried[2]) > 0.98 * norm(tried) && lift > 0.0;
      const bool blocked = std::any_of(
          boxes.begin(), boxes.end(),
          [&](const std::array<double, 6>& box) { return crosses(box, target, tried); });
      if (!overThePole && !blocked) {
        best = &tried;
      }
    }
  }
  if (best == nullptr || boxes.empty()) {
    d.setCamera(target, plus(target, arm), up);
    return;
  }
  const bool asBefore = norm(minus(*best, arm)) < 1e-9 * norm(arm);
  d.setCamera(target, plus(target, *best), asBefore ? up : Point{0, 0, 1});
}

bool View::sees(const std::array<double, 6>& box) const {
  const Impl& d = *impl_;
  const Point focal = pointOf(d.camera()->GetFocalPoint());
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    inside = inside && focal[i] >= box[2 * i] && focal[i] <= box[2 * i + 1];
  }
  if (inside) {
    return true;
  }
  const Scene::Ray ray = d.ray(0, 0);
  for (int corner = 0; corner < 9; ++corner) {
    Point p{};
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = corner == 8 ? 0.5 * (box[2 * i] + box[2 * i + 1]) : box[2 * i + ((corner >> i) & 1)];
    }
    double clip[4];
    for (int i = 0; i < 4; ++i) {
      clip[i] = ray.worldToClip[4 * i] * p[0] + ray.worldToClip[4 * i + 1] * p[1] +
                ray.worldToClip[4 * i + 2] * p[2] + ray.worldToClip[4 * i + 3];
    }
    if (clip[3] > 0.0 && std::abs(clip[0]) <= clip[3] && std::abs(clip[1]) <= clip[3]) {
      return true;
    }
  }
  return false;
}

Point View::eye() const {
  return pointOf(impl_->camera()->GetPosition());
}

Point View::focus() const {
  return pointOf(impl_->camera()->GetFocalPoint());
}

Pick View::pick(double x, double y, Wanted wanted) const {
  const Scene::Ray ray = impl_->ray(x, y);
  Pick pick;
  if (wanted.moves) {
    pick = impl_->scene.pickMove(ray);
  }
  if (pick.kind == Pick::Kind::None && wanted.edges) {
    pick = impl_->scene.pickEdge(ray);
  }
  if (pick.kind == Pick::Kind::None && wanted.faces) {
    pick = impl_->scene.pickFace(ray);
  }
  return pick;
}

std::array<double, 2> View::project(const Point& p) const {
  const Scene::Ray ray = impl_->ray(0, 0);
  double clip[4];
  for (int i = 0; i < 4; ++i) {
    clip[i] = ray.worldToClip[4 * i] * p[0] + ray.worldToClip[4 * i + 1] * p[1] +
              ray.worldToClip[4 * i + 2] * p[2] + ray.worldToClip[4 * i + 3];
  }
  return {(clip[0] / clip[3] + 1.0) * 0.5 * ray.width,
          ray.height - (clip[1] / clip[3] + 1.0) * 0.5 * ray.height};
}

}  // namespace wcam::viewport
