/** The wizards: new projects, and chains from their descriptions in JSON. */
package dev.eventchain.eclipse.ui.wizards;
