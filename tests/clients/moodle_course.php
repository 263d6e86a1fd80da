<?php
// A course of a Moodle's with one assignment: made, handed in to, exported from, imported into and read, by Moodle's own code.
//
//   php moodle_course.php MOODLE ACTION ARGUMENTS.json
//
// MOODLE is the folder of an installed Moodle. Every action but `open` names the `assignment` that `open` printed; `decimal` is
// the sign that the site's language writes decimals with. Files of Moodle's are printed as they are, everything else as JSON.
// What Moodle says where it takes nothing of a file is printed as {"refused": [sentence, ...]}.

define('CLI_SCRIPT', true);
[, $folder, $action, $arguments] = $argv;
require $folder . '/config.php';
error_reporting(E_ERROR | E_PARSE);
ini_set('display_errors', 'stderr');
$CFG->debug = 0;
$CFG->debugdisplay = 0;
$CFG->noemailever = true;
require_once $CFG->libdir . '/testing/generator/lib.php';
require_once $CFG->libdir . '/testing/generator/data_generator.php';
require_once $CFG->libdir . '/csvlib.class.php';
require_once $CFG->libdir . '/gradelib.php';
require_once $CFG->dirroot . '/course/lib.php';
require_once $CFG->dirroot . '/grade/export/txt/grade_export_txt.php';
require_once $CFG->dirroot . '/grade/import/lib.php';
require_once $CFG->dirroot . '/mod/assign/locallib.php';
require_once $CFG->dirroot . '/mod/assign/feedback/file/importziplib.php';
require_once $CFG->dirroot . '/mod/assign/feedback/offline/importgradeslib.php';

$given = json_decode(file_get_contents($arguments), true, 512, JSON_THROW_ON_ERROR);
\core\session\manager::set_user(get_admin());
if (($given['decimal'] ?? '.') === ',') { // as a site does that customises its language
    $CFG->langlocalroot = make_temp_directory('corollary_lang');
    check_dir_exists("$CFG->langlocalroot/en_local");
    file_put_contents(
        "$CFG->langlocalroot/en_local/langconfig.php",
        "<?php \$string['decsep'] = ','; \$string['listsep'] = ';';"
    );
    $CFG->langstringcache = false;
    get_string_manager(true);
}
$PAGE->set_url('/');
if ($action !== 'open') {
    [$course, $cm] = get_course_and_cm_from_cmid($given['assignment'], 'assign');
    $context = context_module::instance($cm->id);
    $assign = new assign($context, $cm, $course);
    $PAGE->set_cm($cm, $course);
}

/** The users of the course that are students, by username. */
function enrolled(assign $assign): array {
    return array_column($assign->list_participants(0, false), null, 'username');
}

function open_course(array $given): array {
    global $DB;
    $generator = new testing_data_generator();
    $course = $generator->create_course(['fullname' => 'Mechanics', 'shortname' => uniqid('mechanics')]);
    foreach ($given['students'] as $each) {
        $user = $DB->get_record('user', ['username' => $each['username']]);
        $user = $user ?: $generator->create_user($each);
        $generator->enrol_user($user->id, $course->id, 'student');
    }
    $made = $generator->create_module('assign', [
        'course' => $course->id, 'name' => $given['title'], 'grade' => $given['out_of'], 'duedate' => $given['due'] ?? 0,
        'assignsubmission_file_enabled' => 1, 'assignsubmission_file_maxfiles' => 5,
        'assignsubmission_file_maxsizebytes' => 10 << 20, 'assignsubmission_onlinetext_enabled' => 1, 'submissiondrafts' => 0,
        'assignfeedback_file_enabled' => 1, 'assignfeedback_offline_enabled' => 1, 'assignfeedback_comments_enabled' => 0,
    ]);
    return ['version' => $GLOBALS['CFG']->release, 'assignment' => $made->cmid];
}

/** Marks given by hand in the assignment itself. */
function mark(assign $assign, array $marks): array {
    foreach ($marks as $username => $mark) {
        $grade = $assign->get_user_grade(enrolled($assign)[$username]->id, true);
        $grade->grade = $mark;
        $assign->update_grade($grade);
    }
    return [];
}

/** Files that students hand in, each at a moment of its own. */
function submit(assign $assign, array $handed_in): array {
    global $DB;
    foreach ($handed_in as $each) {
        $user = enrolled($assign)[$each['username']];
        \core\session\manager::set_user($user);
        $draft = file_get_unused_draft_itemid();
        foreach ($each['files'] as $name => $path) {
            get_file_storage()->create_file_from_pathname([
                'contextid' => context_user::instance($user->id)->id, 'component' => 'user', 'filearea' => 'draft',
                'itemid' => $draft, 'filepath' => '/', 'filename' => $name,
            ], $path);
        }
        $notices = [];
        $text = ['text' => '', 'format' => FORMAT_HTML, 'itemid' => file_get_unused_draft_itemid()];
        $data = (object) ['userid' => $user->id, 'files_filemanager' => $draft, 'onlinetext_editor' => $text];
        if (!$assign->save_submission($data, $notices)) {
            throw new Exception("$user->username cannot hand in: " . implode(' ', $notices));
        }
        $submission = $assign->get_user_submission($user->id, false);
        $DB->set_field('assign_submission', 'timemodified', $each['when'], ['id' => $submission->id]);
    }
    \core\session\manager::set_user(get_admin());
    return [];
}

/** Grades, Export, Plain text file. */
function gradebook(stdClass $course): void {
    $form = grade_export::export_bulk_export_data($course->id, '', false, false, GRADE_DISPLAY_TYPE_REAL, 2);
    $form->separator = 'comma';
    $form->itemids = [];
    foreach (grade_item::fetch_all(['courseid' => $course->id, 'itemtype' => 'mod']) as $item) {
        $form->itemids[$item->id] = 1;
    }
    $form->display = ['real' => GRADE_DISPLAY_TYPE_REAL];
    (new grade_export_txt($course, 0, $form))->print_grades();
}

/** Grades, Import, CSV file, with the column `from` mapped to the user's `to`, and `marks` to the assignment or a new item. */
function import_gradebook(stdClass $course, assign $assign, array $given): array {
    $loaded = new gradeimport_csv_load_data();
    $loaded->load_csv_content(file_get_contents($given['file']), 'UTF-8', $given['separator'] ?? 'comma', 10);
    if ($loaded->get_error()) {
        return ['refused' => [$loaded->get_error()]];
    }
    $reader = new csv_import_reader($loaded->get_iid(), 'grade');
    $header = array_map('trim', $reader->get_columns());
    $at = fn($heading) => array_keys($header, $heading, true);
    if (count($at($given['from'])) !== 1 || count($at($given['marks'])) !== 1) {
        throw new Exception('its columns are ' . json_encode($header, JSON_UNESCAPED_UNICODE));
    }
    $form = (object) ['importcode' => get_new_importcode(), 'forceimport' => false];
    [$form->mapfrom, $form->mapto] = [$at($given['from'])[0], $given['to']];
    foreach ($header as $place => $heading) {
        $form->{"mapping_$place"} = '0';
    }
    $item = empty($given['new']) ? $assign->get_grade_item()->id : 'new';
    $form->{'mapping_' . $at($given['marks'])[0]} = $item;
    $imported = new gradeimport_csv_load_data();
    if (!$imported->prepare_import_grade_data($reader->get_columns(), $form, $reader, $course->id, false, 0, 1)) {
        return ['refused' => $imported->get_gradebookerrors()];
    }
    return ['imported' => grade_import_commit($course->id, $form->importcode, true, false)];
}

/** Upload grading worksheet, as it is confirmed. */
function import_worksheet(assign $assign, string $file): array {
    global $USER;
    $_POST['sesskey'] = sesskey();
    $draft = file_get_unused_draft_itemid();
    get_file_storage()->create_file_from_pathname([
        'contextid' => context_user::instance($USER->id)->id, 'component' => 'user', 'filearea' => 'draft', 'itemid' => $draft,
        'filepath' => '/', 'filename' => basename($file),
    ], $file);
    $iid = csv_import_reader::get_new_iid('assignfeedback_offline');
    $assign->get_feedback_plugin_by_type('offline')->process_import_grades($draft, $iid, false);
    return ['imported' => true];
}

/** Upload multiple feedback files in a zip, as it is confirmed. */
function give_back(assign $assign, string $file): array {
    global $USER;
    $importer = new assignfeedback_file_zip_importer();
    $zip = get_file_storage()->create_file_from_pathname([
        'contextid' => $assign->get_context()->id, 'component' => 'assignfeedback_file',
        'filearea' => ASSIGNFEEDBACK_FILE_IMPORT_FILEAREA, 'itemid' => $USER->id, 'filepath' => '/', 'filename' => 'import.zip',
    ], $file);
    $importer->extract_files_from_zip($zip, $assign->get_context()->id);
    $importer->import_zip_files($assign, $assign->get_feedback_plugin_by_type('file'));
    $importer->delete_import_files($assign->get_context()->id);
    return ['imported' => true];
}

/** By username: the mark in the gradebook (null for none), that of an item made by an import, and the SHA-1 of feedback files. */
function read(stdClass $course, assign $assign): array {
    $made = grade_item::fetch(['courseid' => $course->id, 'itemtype' => 'manual']);
    $found = [];
    foreach (enrolled($assign) as $username => $user) {
        $mark = fn($item) => grade_grade::fetch(['itemid' => $item->id, 'userid' => $user->id]) ?: null;
        $number = fn($grade) => $grade?->finalgrade === null ? null : (float) $grade->finalgrade;
        $files = [];
        if ($grade = $assign->get_user_grade($user->id, false)) {
            $area = [$assign->get_context()->id, 'assignfeedback_file', ASSIGNFEEDBACK_FILE_FILEAREA, $grade->id, 'id', false];
            foreach (get_file_storage()->get_area_files(...$area) as $file) {
                $files[$file->get_filepath() . $file->get_filename()] = $file->get_contenthash();
            }
        }
        $found[$username] = [
            'mark' => $number($mark($assign->get_grade_item())), 'new' => $made ? $number($mark($made)) : null,
            'files' => (object) $files,
        ];
    }
    return ['students' => $found];
}

switch ($action) {
    case 'gradebook':
        gradebook($course);
        break;
    case 'worksheet':
        (new ReflectionMethod($assign->get_feedback_plugin_by_type('offline'), 'download_grades'))
            ->invoke($assign->get_feedback_plugin_by_type('offline'));
        break;
    case 'submissions':
        set_user_preference('assign_downloadasfolders', (int) $given['folders']);
        (new ReflectionMethod($assign, 'download_submissions'))->invoke($assign);
        break;
    default:
        ob_start();
        $said = match ($action) {
            'open' => open_course($given),
            'mark' => mark($assign, $given['marks']),
            'submit' => submit($assign, $given['handed_in']),
            'import-gradebook' => import_gradebook($course, $assign, $given),
            'import-worksheet' => import_worksheet($assign, $given['file']),
            'give-back' => give_back($assign, $given['file']),
            'read' => read($course, $assign),
            'close' => ['closed' => delete_course($course, false)],
        };
        ob_end_clean();
        echo json_encode($said, JSON_UNESCAPED_UNICODE | JSON_THROW_ON_ERROR);
}
