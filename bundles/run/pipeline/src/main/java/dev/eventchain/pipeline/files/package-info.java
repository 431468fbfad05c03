/** The files written by a command without a project. Depends only on the output folder. */
package dev.eventchain.pipeline.files;
