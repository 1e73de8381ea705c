! SPDX-License-Identifier: BSD-3-Clause
! USERMAT of Ansys: small strain J2 plasticity with linear isotropic hardening, by radial return.
! prop: E, nu, yield, isotropic, which. ustatev: p.
! which: 1 asks for a shorter step where a strain increment exceeds 0.1; 2 the same with a factor; 3 writes past ustatev;
! 4 writes to dStrain; 5 takes the shears for those of a tensor; 6 returns the stress of neo-Hookean elasticity, in the
! axes of R, by defGrad; 7 and 8 add its modulus of the Truesdell rate, of J sigma over J and of tau.
subroutine usermat(matid, elemid, kdomintpt, klayer, ksectpt, ldstep, isubst, keycut, ndirect, nshear, ncomp, nstatev, &
                   nprop, time, dtime, temp, dtemp, stress, ustatev, dsdepl, sedel, sedpl, epseq, strain, dstrain, epspl, &
                   prop, coords, var0, defgrad_t, defgrad, tsstif, epszz, cutfactor, var1, var2, var3, var4, var5, var6, &
                   var7)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer :: matid, elemid, kdomintpt, klayer, ksectpt, ldstep, isubst, keycut, ndirect, nshear, ncomp, nstatev, nprop
  real(dp) :: time, dtime, temp, dtemp, stress(ncomp), ustatev(*), dsdepl(ncomp, ncomp), sedel, sedpl, epseq, &
              strain(ncomp), dstrain(ncomp), epspl(ncomp), prop(nprop), coords(3), var0, defgrad_t(3, 3), &
              defgrad(3, 3), tsstif(2), epszz, cutfactor, var1, var2, var3, var4, var5, var6, var7
  real(dp) :: g, k, s(ncomp), n(ncomp), q, p, h, trial, factor, unit(ncomp), c, u(3, 3), j
  integer :: i, which

  which = nint(prop(5))
  keycut = 0
  if ((which == 1 .or. which == 2) .and. maxval(abs(dstrain)) > 0.1_dp) then
    keycut = 1
    if (which == 2) cutfactor = 0.2_dp
    return
  end if
  g = prop(1) / (2 * (1 + prop(2)))
  k = prop(1) / (3 * (1 - 2 * prop(2)))
  h = prop(4)
  unit = 0
  unit(1:3) = 1
  if (which >= 6) then
    u = matmul(transpose(defgrad), defgrad)  ! U U = R^T b R: the stress of the law in the axes of R
    j = sqrt(determinant(u))
    c = (k - 2 * g / 3) * log(j) / j
    stress(1:3) = [(c + g / j * (u(i, i) - 1), i = 1, 3)]
    stress(4) = g / j * u(1, 2)
    if (ncomp == 6) stress(5:6) = g / j * [u(2, 3), u(1, 3)]
    if (which == 6) return
    dsdepl = 0
    dsdepl(1:3, 1:3) = k - 2 * g / 3
    do i = 1, ncomp
      dsdepl(i, i) = dsdepl(i, i) + merge(2._dp, 1._dp, i <= 3) * (g - j * c)
    end do
    if (which == 7) dsdepl = dsdepl / j
    return
  end if
  do i = 1, ncomp
    s(i) = merge(2._dp, 1._dp, i <= 3 .or. which == 5) * g * dstrain(i)
  end do
  stress = stress + s + (k - 2 * g / 3) * sum(dstrain(1:3)) * unit
  s = stress - sum(stress(1:3)) / 3 * unit
  q = sqrt(1.5_dp * (sum(s(1:3)**2) + 2 * sum(s(4:)**2)))
  p = ustatev(1)
  trial = q - prop(3) - h * p
  do i = 1, ncomp
    dsdepl(:, i) = k * unit * unit(i) - 2 * g / 3 * unit * unit(i)
    dsdepl(i, i) = dsdepl(i, i) + merge(2._dp, 1._dp, i <= 3) * g
  end do
  if (trial > 0) then
    p = p + trial / (3 * g + h)
    factor = 3 * g * trial / (3 * g + h) / q
    n = s / q
    do i = 1, ncomp  ! consistent: K I x I + 2 G (1 - factor) dev + c n x n
      dsdepl(:, i) = (k - 2 * g * (1 - factor) / 3) * unit * unit(i) &
                     - 9 * g**2 * (1 / (3 * g + h) - trial / (3 * g + h) / q) * n * n(i)
      dsdepl(i, i) = dsdepl(i, i) + merge(2._dp, 1._dp, i <= 3) * g * (1 - factor)
    end do
    stress = stress - factor * s
    sedpl = sedpl + (prop(3) + h * p) * trial / (3 * g + h)
    epspl = epspl + 1.5_dp * trial / (3 * g + h) * n * [1._dp, 1._dp, 1._dp, (2._dp, i = 4, ncomp)]
  end if
  ustatev(1) = p
  epseq = p
  if (which == 3) ustatev(2) = 1
  if (which == 4) dstrain(1) = 0

contains

  pure real(dp) function determinant(f)
    real(dp), intent(in) :: f(3, 3)
    determinant = f(1, 1) * (f(2, 2) * f(3, 3) - f(2, 3) * f(3, 2)) &
                  - f(1, 2) * (f(2, 1) * f(3, 3) - f(2, 3) * f(3, 1)) &
                  + f(1, 3) * (f(2, 1) * f(3, 2) - f(2, 2) * f(3, 1))
  end function determinant
end subroutine usermat
