// A `pinocchio::Model` from the text that model.py writes, so that nothing here links the libraries of the wheel: they are
// compiled for any x86-64, and Eigen's alignment under `-march=native` is not theirs.
#pragma once
#include <pinocchio/multibody.hpp>

#include <fstream>
#include <stdexcept>
#include <string>

namespace pin = pinocchio;

// The kinds of joints that a model may have, where a program does not say which.
#ifndef JOINTS
#define JOINTS pin::JointCollectionDefaultTpl
#endif
template <typename Scalar> using ModelOf = pin::ModelTpl<Scalar, 0, JOINTS>;
template <typename Scalar> using DataOf = pin::DataTpl<Scalar, 0, JOINTS>;
typedef ModelOf<double> Model;
typedef DataOf<double> Data;

template <int Rows, int Columns> Eigen::Matrix<double, Rows, Columns> read(std::istream &in) {
  Eigen::Matrix<double, Rows, Columns> m;
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j < Columns; ++j) in >> m(i, j);
  return m;
}

// Throws where the file is missing or short, or holds a joint of another kind.
inline Model read_model(const std::string &path) {
  typedef JOINTS<double, 0> J;
  std::ifstream in(path);
  Model model;
  int joints = 0;
  in >> model.name >> joints;
  for (int i = 0; i < joints; ++i) {
    int parent;
    std::string kind, name;
    in >> parent >> kind >> name;
    const Eigen::Vector3d axis = read<3, 1>(in);
    const Eigen::Matrix3d rotation = read<3, 3>(in);
    const Eigen::Vector3d place = read<3, 1>(in);
    const double mass = read<1, 1>(in).value();
    const Eigen::Vector3d center = read<3, 1>(in);
    const Eigen::Matrix3d inertia = read<3, 3>(in);
    Model::JointModel joint;
    if (kind == "FreeFlyer") joint = typename J::JointModelFreeFlyer();
    else if (kind == "RX") joint = typename J::JointModelRX();
    else if (kind == "RY") joint = typename J::JointModelRY();
    else if (kind == "RZ") joint = typename J::JointModelRZ();
    else if (kind == "RevoluteUnaligned") joint = typename J::JointModelRevoluteUnaligned(axis);
    else throw std::runtime_error(path + ": a joint of kind " + kind);
    const auto id = model.addJoint(parent, joint, pin::SE3(rotation, place), name);
    model.addJointFrame(id);
    model.appendBodyToJoint(id, pin::Inertia(mass, center, inertia), pin::SE3::Identity());
  }
  if (!in || joints == 0) throw std::runtime_error(path + ": missing or short");
  return model;
}

// The joint of this name. Throws where there is none.
inline pin::JointIndex tip_of(const Model &model, const std::string &joint) {
  if (!model.existJointName(joint)) throw std::runtime_error("no joint " + joint);
  return model.getJointId(joint);
}
