"""What takes measured, for laboratories and clinics: one page and one table."""
