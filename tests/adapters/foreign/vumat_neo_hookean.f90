! SPDX-License-Identifier: BSD-3-Clause
! Compressible neo-Hookean elasticity, (34), in the axes of the Green-Naghdi rotation:
! sigma = (lambda ln J / J) I + (mu / J) (U^2 - I). PROPS: E, nu. No state.
subroutine vumat(nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal, steptime, totaltime, dt, cmname, coordmp, &
                 charlength, props, density, straininc, relspininc, tempold, stretchold, defgradold, fieldold, &
                 stressold, stateold, enerinternold, enerinelasold, tempnew, stretchnew, defgradnew, fieldnew, &
                 stressnew, statenew, enerinternnew, enerinelasnew)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, intent(in) :: nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal
  character(len=80), intent(in) :: cmname
  real(dp), intent(in) :: steptime, totaltime, dt, coordmp(nblock, *), charlength(nblock), props(nprops), &
                          density(nblock), straininc(nblock, ndir + nshr), relspininc(nblock, nshr), &
                          tempold(nblock), stretchold(nblock, ndir + nshr), defgradold(nblock, ndir + 2 * nshr), &
                          fieldold(nblock, nfieldv), stressold(nblock, ndir + nshr), stateold(nblock, nstatev), &
                          enerinternold(nblock), enerinelasold(nblock), tempnew(nblock), &
                          stretchnew(nblock, ndir + nshr), defgradnew(nblock, ndir + 2 * nshr), &
                          fieldnew(nblock, nfieldv)
  real(dp), intent(inout) :: stressnew(nblock, ndir + nshr), statenew(nblock, nstatev), enerinternnew(nblock), &
                             enerinelasnew(nblock)
  integer, parameter :: row(6) = [1, 2, 3, 1, 2, 3], column(6) = [1, 2, 3, 2, 3, 1]
  real(dp) :: lambda, mu, jacobian, u(3, 3), square, work
  integer :: k, i

  lambda = props(1) * props(2) / ((1 + props(2)) * (1 - 2 * props(2)))
  mu = props(1) / (2 * (1 + props(2)))
  do k = 1, nblock
    u = 0
    do i = 1, ndir + nshr
      u(row(i), column(i)) = stretchnew(k, i)
      u(column(i), row(i)) = stretchnew(k, i)
    end do
    jacobian = u(1, 1) * (u(2, 2) * u(3, 3) - u(2, 3)**2) - u(1, 2) * (u(1, 2) * u(3, 3) - u(2, 3) * u(1, 3)) &
               + u(1, 3) * (u(1, 2) * u(2, 3) - u(2, 2) * u(1, 3))
    work = 0
    do i = 1, ndir + nshr
      square = dot_product(u(row(i), :), u(column(i), :))
      if (i <= ndir) then
        stressnew(k, i) = lambda * log(jacobian) / jacobian + mu / jacobian * (square - 1)
      else
        stressnew(k, i) = mu / jacobian * square
      end if
      work = work + merge(1, 2, i <= ndir) * (stressold(k, i) + stressnew(k, i)) / 2 * straininc(k, i)
    end do
    enerinternnew(k) = enerinternold(k) + work / density(k)
    enerinelasnew(k) = enerinelasold(k)
  end do
end subroutine vumat
