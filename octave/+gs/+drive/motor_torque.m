## T = gs.drive.motor_torque (c, motor, gear)
## The torque of a motor along the load cycle C, through a gear whose losses follow the direction of
## power.

function T = motor_torque (c, motor, gear)
  N = gear.ratio;
  speed = N * c.omega;
  T = c.torque / (N * gear.eta);
  back = c.torque .* c.omega < 0;
  T(back) = c.torque(back) * gear.eta_back / N;
  T += (motor.Jm + gear.J_in) * N * c.alpha + motor.bm * speed + motor.Tc * sign (speed);
endfunction
