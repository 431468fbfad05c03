/**
 * What has to hold for models and for the chain of a project, and what is found about them. It
 * reads files and runs no stage: it knows no language model, generates nothing and simulates
 * nothing, so that an editor can check with the very code of the command line.
 */
package dev.eventchain.check;
