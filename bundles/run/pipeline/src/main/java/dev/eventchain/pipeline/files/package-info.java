/** The files that a command without a project wrote. Knows only the output folder. */
package dev.eventchain.pipeline.files;
