/** Facts about the requirements of a project, and effects of a change of them. */
package dev.eventchain.pipeline.requirements;
