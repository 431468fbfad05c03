package dev.eventchain.eclipse.ui.text;

/** The two languages. */
enum Language {
  OCL,
  TEMPLATE
}
