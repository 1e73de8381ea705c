// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/command_line.hpp"

int main(int argc, char** argv) { return assay::drivers::command_line(argc, argv); }
