"""A robot hand that follows the wearer's: its model, how it is driven, the scene it grasps in.

The same estimates and commands give the same robot to the last bit. All but `worn`, `settings` and
`library` need the extra ``robot`` (MuJoCo). See extensions/robot/docs/robot.md.
"""
