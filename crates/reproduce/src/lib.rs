//! The study of Diehl (1995), repeated.
