/** Readers of requirements in the formats of other tools. They know no project. */
package dev.eventchain.project.requirements;
