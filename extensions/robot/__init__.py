"""A robot hand that follows the wearer's: its model, how it is driven, the scene it grasps in.

The same estimates and commands give the same states, bit for bit. All modules except `wearer_hand`,
`settings` and `library` require the extra ``robot`` (MuJoCo). See extensions/robot/docs/robot.md.
"""
