/** Checks of the edited chain in the background, and the findings about its elements. */
package dev.eventchain.eclipse.ui.editor.validation;
