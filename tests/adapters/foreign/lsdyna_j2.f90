! SPDX-License-Identifier: BSD-3-Clause
! User materials of LS-DYNA, in double precision. umat41: small strain J2 plasticity with linear isotropic hardening.
! cm: E, nu, yield, isotropic, which. hsv: p.
! which: 1 rejects a strain increment above 0.1; 2 deletes the point there; 3 writes past hsv; 4 writes to cm; 6 is
! neo-Hookean elasticity by the F of IHYPER = 1, which stands behind the one number of hsv.
! umat42, umat43 and umat44 are umat41 with the arguments of older releases: 16, 12 and 13.
subroutine umat41(cm, eps, sig, epsp, hsv, dt1, capa, etype, tt, temper, failel, crv, nnpcrv, cma, qmat, elsiz, idele, &
                  reject)
  implicit none
  integer, parameter :: dp = kind(1d0)
  real(dp) :: cm(*), eps(6), sig(6), epsp, hsv(*), dt1, capa, tt, temper, crv(*), cma(*), qmat(3, 3), elsiz
  character(len=*) :: etype
  logical :: failel, reject
  integer :: nnpcrv(*), idele

  if (etype /= 'solid') error stop 'another element'
  if (nint(cm(5)) == 1 .and. maxval(abs(eps)) > 0.1_dp) reject = .true.
  if (nint(cm(5)) == 2 .and. maxval(abs(eps)) > 0.1_dp) failel = .true.
  if (nnpcrv(1) /= 0 .or. abs(qmat(1, 1) - 1) > 0 .or. reject .or. failel) return
  call law(cm, eps, sig, epsp, hsv)
end subroutine umat41

subroutine umat42(cm, eps, sig, epsp, hsv, dt1, capa, etype, tt, temper, failel, crv, cma, qmat, elsiz, idele)
  implicit none
  integer, parameter :: dp = kind(1d0)
  real(dp) :: cm(*), eps(6), sig(6), epsp, hsv(*), dt1, capa, tt, temper, crv(*), cma(*), qmat(3, 3), elsiz
  character(len=*) :: etype
  logical :: failel
  integer :: idele

  if (etype /= 'solid' .or. abs(qmat(2, 2) - 1) > 0) error stop 'another element'
  call law(cm, eps, sig, epsp, hsv)
end subroutine umat42

subroutine umat43(cm, eps, sig, epsp, hsv, dt1, capa, etype, tt, temper, failel, crv)
  implicit none
  integer, parameter :: dp = kind(1d0)
  real(dp) :: cm(*), eps(6), sig(6), epsp, hsv(*), dt1, capa, tt, temper, crv(*)
  character(len=*) :: etype
  logical :: failel

  if (etype /= 'solid') error stop 'another element'
  call law(cm, eps, sig, epsp, hsv)
end subroutine umat43

subroutine umat44(cm, eps, sig, epsp, hsv, dt1, capa, etype, tt, temper, failel, crv, nnpcrv)
  implicit none
  integer, parameter :: dp = kind(1d0)
  real(dp) :: cm(*), eps(6), sig(6), epsp, hsv(*), dt1, capa, tt, temper, crv(*)
  character(len=*) :: etype
  logical :: failel
  integer :: nnpcrv(*)

  if (etype /= 'solid' .or. nnpcrv(1) /= 0) error stop 'another element'
  call law(cm, eps, sig, epsp, hsv)
end subroutine umat44

subroutine law(cm, eps, sig, epsp, hsv)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, parameter :: row(6) = [1, 2, 3, 1, 2, 3], column(6) = [1, 2, 3, 2, 3, 1]
  real(dp), intent(inout) :: cm(*), sig(6), epsp, hsv(*)
  real(dp), intent(in) :: eps(6)
  real(dp) :: g, k, s(6), q, excess, p, f(3, 3), b(3, 3), j
  integer :: i

  g = cm(1) / (2 * (1 + cm(2)))
  k = cm(1) / (3 * (1 - 2 * cm(2)))
  if (nint(cm(5)) == 6) then
    f = reshape(hsv(2:10), [3, 3])
    b = matmul(f, transpose(f))
    j = f(1, 1) * (f(2, 2) * f(3, 3) - f(2, 3) * f(3, 2)) - f(1, 2) * (f(2, 1) * f(3, 3) - f(2, 3) * f(3, 1)) &
        + f(1, 3) * (f(2, 1) * f(3, 2) - f(2, 2) * f(3, 1))
    do i = 1, 6
      sig(i) = g / j * b(row(i), column(i))
      if (i <= 3) sig(i) = sig(i) + ((k - 2 * g / 3) * log(j) - g) / j
    end do
    return
  end if
  sig(1:3) = sig(1:3) + 2 * g * eps(1:3) + (k - 2 * g / 3) * sum(eps(1:3))
  sig(4:6) = sig(4:6) + g * eps(4:6)
  s = sig
  s(1:3) = s(1:3) - sum(sig(1:3)) / 3
  q = sqrt(1.5_dp * (sum(s(1:3)**2) + 2 * sum(s(4:6)**2)))
  p = hsv(1)
  excess = q - cm(3) - cm(4) * p
  if (excess > 0) then
    p = p + excess / (3 * g + cm(4))
    sig = sig - 3 * g * excess / (3 * g + cm(4)) / q * s
  end if
  hsv(1) = p
  epsp = p
  if (nint(cm(5)) == 3) hsv(2) = 1
  if (nint(cm(5)) == 4) cm(1) = 2 * cm(1)
end subroutine law
