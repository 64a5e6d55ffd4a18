//! Texts to cards.

mod limits;
mod print_back;
mod syntax;
