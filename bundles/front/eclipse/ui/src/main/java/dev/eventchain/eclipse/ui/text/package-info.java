/** The editors of constraints and templates, which show what the analysis of the engine finds. */
package dev.eventchain.eclipse.ui.text;
