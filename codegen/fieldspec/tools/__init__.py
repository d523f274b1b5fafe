"""What people do with a spec beside generating code: lists, audits, simulated and real devices, captures, evidence."""
