// What a motion consists of, with the columns of its logs (motion_columns.h), in the order of a
// comparison's differences.

export const QUANTITIES = [
  {title: "Position", unit: "m", names: ["x", "y", "z"]},
  {title: "Orientation", unit: "°", names: ["roll", "pitch", "yaw"]},
  {title: "Velocity", unit: "m/s", names: ["vx", "vy", "vz"]},
  {title: "Angular velocity", unit: "rad/s", names: ["wx", "wy", "wz"], labels: ["ωx", "ωy", "ωz"]}];
