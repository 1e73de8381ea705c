! SPDX-License-Identifier: BSD-3-Clause
! A library without the entry symbol: assay_add_material must fail its build.
subroutine update() bind(c)
end subroutine update
