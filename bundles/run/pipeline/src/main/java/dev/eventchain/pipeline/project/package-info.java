/**
 * A user's folder with its configuration: language models, template and metadata of the generated
 * package. Depends on no run.
 */
package dev.eventchain.pipeline.project;
