"""Reports on recordings for laboratories and clinics: one page and one table."""
