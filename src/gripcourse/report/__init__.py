"""What people read: student reports, cohort reports and grade tables."""
