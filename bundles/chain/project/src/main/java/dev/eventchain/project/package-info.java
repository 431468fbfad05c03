/**
 * Project folders of users: files, settings, requirements, software base and suppressions. The
 * package reads them but checks no chain.
 */
package dev.eventchain.project;
